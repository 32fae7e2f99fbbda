// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plane/triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <set>

namespace trivar {
namespace {

constexpr int after(int i)
{
    return i == 2 ? 0 : i + 1;
}
constexpr int before(int i)
{
    return i == 0 ? 2 : i - 1;
}
auto at(int i)
{
    return static_cast<std::size_t>(i);
}
int slot_of(const Triangulation::Corners& v, int value)
{
    return v[0] == value ? 0 : v[1] == value ? 1 : v[2] == value ? 2 : -1;
}
// Sine and cosine of the angle at a, both times the lengths of its legs.
std::pair<double, double> angle_at(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c)
{
    const glm::dvec2 u = glm::dvec2(b) - glm::dvec2(a), v = glm::dvec2(c) - glm::dvec2(a);
    return {static_cast<double>(turn(a, b, c)), glm::dot(u, v)};
}
double square(const glm::dvec2& v)
{
    return glm::dot(v, v);
}

} // namespace

Triangulation::Triangulation()
    : points_{{-4 * most_units, -3 * most_units},
              {4 * most_units, -3 * most_units},
              {0, 5 * most_units}},
      triangle_at_{0, 0, 0},
      triangles_{{.v = {0, 1, 2}, .n = {-1, -1, -1}}}
{
}

std::int64_t Triangulation::turn_of(int a, int b, int c) const
{
    return turn(points_[at(a)], points_[at(b)], points_[at(c)]);
}

// Walks from a triangle to the one that p lies in or on the rim of. Not `through` edges that stay:
// -1 where one is in the way. Which way it looks first changes with each step, so that it does not
// go round in circles.
int Triangulation::locate(const glm::ivec2& p, int from, bool through) const
{
    const std::size_t most = 4 * triangles_.size() + 16;
    for (std::size_t step = 0; step < most; ++step) {
        const Triangle& t = triangles_[at(from)];
        int next = -1;
        for (int k = 0; k < 3 && next < 0; ++k) {
            const int i = (k + static_cast<int>(step % 3)) % 3;
            if (turn(points_[at(t.v[at(after(i))])], points_[at(t.v[at(before(i))])], p) >= 0)
                continue;
            if (!through && t.stays[at(i)]) return -1;
            next = t.n[at(i)];
            if (next < 0) return -1;
        }
        if (next < 0) return from;
        from = next;
    }
    return -1;
}

// One triangle into three about a new point. On a rim one of them is flat till it is flipped.
int Triangulation::split(int triangle, const glm::ivec2& p)
{
    const int point = static_cast<int>(points_.size());
    points_.push_back(p);
    triangle_at_.push_back(triangle);
    const Triangle old = triangles_[at(triangle)];
    const int second = static_cast<int>(triangles_.size()), third = second + 1;
    const std::array<int, 3> own{triangle, second, third};
    triangles_.resize(triangles_.size() + 2);
    for (int i = 0; i < 3; ++i) { // the one on side i of the old
        Triangle& t = triangles_[at(own[at(i)])];
        const int a = old.v[at(after(i))], b = old.v[at(before(i))];
        t.v = {point, a, b};
        t.n = {old.n[at(i)], own[at(after(i))], own[at(before(i))]};
        t.stays = {old.stays[at(i)], false, false};
        t.inside = old.inside;
        if (const Side back = twin({own[at(i)], 0}); back.triangle >= 0)
            triangles_[at(back.triangle)].n[at(back.side)] = own[at(i)];
        triangle_at_[at(a)] = own[at(i)];
    }
    settle_round(point);
    return point;
}

Triangulation::Side Triangulation::twin(Side s) const
{
    assert(s.triangle >= 0);
    const Triangle& t = triangles_[at(s.triangle)];
    const int other = t.n[at(s.side)];
    if (other < 0) return {-1, 0};
    const Corners& v = triangles_[at(other)].v;
    const int a = slot_of(v, t.v[at(after(s.side))]), b = slot_of(v, t.v[at(before(s.side))]);
    assert(a >= 0 && b >= 0);
    return {other, 3 - a - b};
}

//      a             a
//     / \           /|\            t is left, u right afterwards
//    b---c   ->    b | c           t = a b d, u = a d c
//     \ /           \|/
//      d             d
void Triangulation::flip(Side s)
{
    const Side o = twin(s);
    Triangle &t = triangles_[at(s.triangle)], &u = triangles_[at(o.triangle)];
    assert(!t.stays[at(s.side)]);
    const int a = t.v[at(s.side)], b = t.v[at(after(s.side))], c = t.v[at(before(s.side))];
    const int d = u.v[at(o.side)];
    const int ca = t.n[at(after(s.side))], ab = t.n[at(before(s.side))];
    const bool ca_stays = t.stays[at(after(s.side))], ab_stays = t.stays[at(before(s.side))];
    const int bd = u.n[at(after(o.side))], dc = u.n[at(before(o.side))]; // u is d c b
    const bool bd_stays = u.stays[at(after(o.side))], dc_stays = u.stays[at(before(o.side))];
    t.v = {a, b, d};
    t.n = {bd, o.triangle, ab};
    t.stays = {bd_stays, false, ab_stays};
    u.v = {a, d, c};
    u.n = {dc, ca, s.triangle};
    u.stays = {dc_stays, ca_stays, false};
    if (const Side back = twin({s.triangle, 0}); back.triangle >= 0)
        triangles_[at(back.triangle)].n[at(back.side)] = s.triangle;
    if (const Side back = twin({o.triangle, 1}); back.triangle >= 0)
        triangles_[at(back.triangle)].n[at(back.side)] = o.triangle;
    triangle_at_[at(a)] = triangle_at_[at(b)] = triangle_at_[at(d)] = s.triangle;
    triangle_at_[at(c)] = o.triangle;
}

bool Triangulation::flips_well(Side s) const
{
    const Side o = twin(s);
    if (o.triangle < 0 || triangles_[at(s.triangle)].stays[at(s.side)]) return false;
    const Triangle& t = triangles_[at(s.triangle)];
    const int a = t.v[at(s.side)], b = t.v[at(after(s.side))], c = t.v[at(before(s.side))];
    const int d = triangles_[at(o.triangle)].v[at(o.side)];
    return turn_of(a, b, d) > 0 && turn_of(a, d, c) > 0;
}

// The angles opposite to the edge are together at most a half turn. Four points on one circle are
// left as they are: the margin is far above rounding, so that no two flips undo each other.
bool Triangulation::is_delaunay(Side s) const
{
    constexpr double margin = 1e-10;
    const Side o = twin(s);
    if (o.triangle < 0) return true;
    const Triangle& t = triangles_[at(s.triangle)];
    const auto p = [&](int i) -> const glm::ivec2& { return points_[at(i)]; };
    const int b = t.v[at(after(s.side))], c = t.v[at(before(s.side))];
    const auto [sin_a, cos_a] = angle_at(p(t.v[at(s.side)]), p(b), p(c));
    const auto [sin_d, cos_d] = angle_at(p(triangles_[at(o.triangle)].v[at(o.side)]), p(c), p(b));
    const double one = sin_a * cos_d, other = cos_a * sin_d;
    return one + other >= -margin * (std::abs(one) + std::abs(other));
}

void Triangulation::settle_round(int point)
{
    std::vector<Side> open;
    const auto look_across = [&](int triangle) {
        open.push_back({triangle, slot_of(triangles_[at(triangle)].v, point)});
    };
    const int first = triangle_at_[at(point)];
    for (int t = first; look_across(t), (t = turn_round(point, t)) != first;) {
    }
    while (!open.empty()) {
        Side s = open.back();
        open.pop_back();
        s.side = slot_of(triangles_[at(s.triangle)].v, point);
        if (s.side < 0 || !flips_well(s) || is_delaunay(s)) continue;
        const int other = triangles_[at(s.triangle)].n[at(s.side)];
        flip(s);
        look_across(s.triangle);
        look_across(other);
    }
}

// The next triangle about a point, counter-clockwise.
int Triangulation::turn_round(int point, int triangle) const
{
    const Triangle& t = triangles_[at(triangle)];
    return t.n[at(after(slot_of(t.v, point)))];
}

int Triangulation::insert(const glm::ivec2& p)
{
    assert(std::abs(p.x) <= most_units && std::abs(p.y) <= most_units);
    last_ = locate(p, last_, true);
    if (last_ < 0) // only where edges that stay led it round in circles
        for (last_ = 0; locate(p, last_, false) != last_;) ++last_;
    for (const int v : triangles_[at(last_)].v)
        if (points_[at(v)] == p) return v;
    return split(last_, p);
}

Triangulation::Side Triangulation::find(int a, int b) const
{
    const int first = triangle_at_[at(a)];
    for (const bool left :
         {true, false}) { // both ways, for a corner of the frame has no full round
        int t = first;
        do {
            const int slot = slot_of(triangles_[at(t)].v, a);
            if (triangles_[at(t)].v[at(after(slot))] == b) return {t, before(slot)};
            t = triangles_[at(t)].n[at(left ? after(slot) : before(slot))];
        } while (t >= 0 && t != first);
        if (t == first) break;
    }
    return {-1, 0};
}

void Triangulation::keep(Side s)
{
    triangles_[at(s.triangle)].stays[at(s.side)] = true;
    const Side o = twin(s);
    triangles_[at(o.triangle)].stays[at(o.side)] = true;
}

Triangulation::Joined Triangulation::join(int a, int b)
{
    bool several = false;
    while (a != b) {
        // The first triangle that a - b enters, and what it crosses till it meets a point.
        std::deque<std::pair<int, int>> crossed;
        int end = -1;
        int t = triangle_at_[at(a)];
        for (const int first = t; end < 0 && crossed.empty();) {
            const int slot = slot_of(triangles_[at(t)].v, a);
            const int p = triangles_[at(t)].v[at(after(slot))];
            const int q = triangles_[at(t)].v[at(before(slot))];
            const std::int64_t side = turn_of(a, b, p);
            const glm::dvec2 way = glm::dvec2(points_[at(b)]) - glm::dvec2(points_[at(a)]);
            const glm::dvec2 leg = glm::dvec2(points_[at(p)]) - glm::dvec2(points_[at(a)]);
            if (side == 0 && glm::dot(way, leg) > 0)
                end = p;
            else if (side < 0 && turn_of(a, b, q) > 0)
                crossed.emplace_back(p, q);
            else
                t = turn_round(a, t);
            assert(end >= 0 || !crossed.empty() || t != first);
        }
        if (end < 0) {
            auto [right, left] = crossed.front();
            while (end < 0) {
                const Side s = find(right, left);
                const Side o = twin(s);
                if (triangles_[at(s.triangle)].stays[at(s.side)]) return Joined::crosses;
                const int apex = triangles_[at(o.triangle)].v[at(o.side)];
                const std::int64_t side = turn_of(a, b, apex);
                if (side == 0)
                    end = apex;
                else {
                    (side > 0 ? left : right) = apex;
                    crossed.emplace_back(right, left);
                }
            }
        }
        several |= end != b;
        for (std::size_t tries = 0; !crossed.empty(); ++tries) {
            assert(tries < 1000000);
            const auto [p, q] = crossed.front();
            crossed.pop_front();
            const Side s = find(p, q);
            if (!flips_well(s)) {
                crossed.emplace_back(p, q);
                continue;
            }
            flip(s); // the new edge is from the second corner of neither
            const int u = triangles_[at(s.triangle)].v[0], w = triangles_[at(s.triangle)].v[2];
            const std::int64_t one = turn_of(a, end, u), other = turn_of(a, end, w);
            if (u != a && u != end && w != a && w != end && (one > 0) != (other > 0))
                crossed.emplace_back(one < 0 ? u : w, one < 0 ? w : u);
        }
        keep(find(a, end));
        a = end;
    }
    return several ? Joined::several : Joined::one_edge;
}

void Triangulation::settle()
{
    for (bool changed = true; changed;) {
        changed = false;
        for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
            for (int i = 0; i < 3; ++i)
                if (!is_delaunay({t, i}) && flips_well({t, i})) {
                    flip({t, i});
                    changed = true;
                }
    }
}

void Triangulation::fill(const std::vector<std::pair<int, int>>& edges)
{
    std::set<std::pair<int, int>> rim;
    for (const auto& [a, b] : edges) rim.emplace(std::min(a, b), std::max(a, b));
    std::vector<int> open;
    const auto enter = [&](int t) {
        if (triangles_[at(t)].inside) return;
        triangles_[at(t)].inside = true;
        open.push_back(t);
    };
    for (const auto& [a, b] : edges) enter(find(a, b).triangle);
    while (!open.empty()) {
        const Triangle t = triangles_[at(open.back())];
        open.pop_back();
        for (int i = 0; i < 3; ++i) {
            const int a = t.v[at(after(i))], b = t.v[at(before(i))];
            if (t.n[at(i)] >= 0 && !rim.contains({std::min(a, b), std::max(a, b)}))
                enter(t.n[at(i)]);
        }
    }
}

void Triangulation::refine(double longest, const std::function<bool(const Corners&)>& may_split,
                           const std::function<void(int point, const Corners&)>& added)
{
    constexpr std::size_t most = 200000; // points: of a letter that fills the grid
    const auto p = [&](int i) { return glm::dvec2(points_[at(i)]); };
    const auto too_long = [&](const Corners& v) {
        for (std::size_t i = 0; i < 3; ++i)
            if (square(p(v[i]) - p(v[(i + 1) % 3])) > longest * longest) return true;
        return false;
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t t = 0; t < triangles_.size() && points_.size() < most; ++t) {
            const Corners v = triangles_[t].v;
            if (!triangles_[t].inside || !too_long(v) || !may_split(v)) continue;
            const glm::dvec2 b = p(v[1]) - p(v[0]), c = p(v[2]) - p(v[0]);
            const double area = 2 * (b.x * c.y - b.y * c.x);
            const glm::dvec2 centre{(c.y * square(b) - b.y * square(c)) / area,
                                    (b.x * square(c) - c.x * square(b)) / area};
            if (!(glm::length(centre) < most_units)) continue; // a sliver's
            const glm::ivec2 at_grid(glm::round(p(v[0]) + centre));
            const int in = locate(at_grid, static_cast<int>(t), false);
            if (in < 0) continue;
            const Corners round = triangles_[at(in)].v;
            if (!may_split(round)) continue;
            if (std::ranges::any_of(round, [&](int k) { return points_[at(k)] == at_grid; }))
                continue;
            added(split(in, at_grid), round);
            changed = true;
        }
    }
}

std::vector<Triangulation::Corners> Triangulation::inside() const
{
    std::vector<Corners> result;
    for (const Triangle& t : triangles_)
        if (t.inside) result.push_back(t.v);
    return result;
}

} // namespace trivar

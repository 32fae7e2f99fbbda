// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/slit_drawing.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <array>
#include <deque>

namespace trivar {
namespace {

constexpr int most_rounds = 1000; // of splitting in one triangle

std::int64_t turn_of(const glm::i64vec2& a, const glm::i64vec2& b, const glm::i64vec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Whether p lies between a and b, and less than half a lattice step from the line: its hot pixel.
// [Hobby, Practical segment intersection with finite precision output, 1999]
bool runs_through(const glm::i64vec2& a, const glm::i64vec2& b, const glm::i64vec2& p)
{
    const glm::i64vec2 d = b - a, e = p - a;
    const std::int64_t along = d.x * e.x + d.y * e.y;
    if (along <= 0 || along >= d.x * d.x + d.y * d.y) return false;
    const std::int64_t across = std::abs(turn_of(a, b, p));
    return across == 0 ||
           2 * across < std::max({std::abs(d.x), std::abs(d.y), std::abs(d.x + d.y)});
}

// The quotient rounded to the nearest whole number.
std::int64_t rounded_quotient(std::int64_t n, std::int64_t d)
{
    if (d < 0) return rounded_quotient(-n, -d);
    const std::int64_t doubled = 2 * n + d;
    return doubled >= 0 ? doubled / (2 * d) : -((-doubled + 2 * d - 1) / (2 * d));
}

} // namespace

struct SlitDrawing::Located {
    std::uint32_t point;
    glm::i64vec2 at;
};

LatticePoint SlitDrawing::point(std::uint32_t number) const
{
    const std::uint32_t own = skin_->point_count();
    return number < own ? LatticePoint{LatticePoint::On::point, number, 0, 0}
                        : points_[number - own];
}

glm::dvec3 SlitDrawing::position(std::uint32_t number) const
{
    return number < skin_->point_count() ? skin_->position(number)
                                         : trivar::position(*skin_, point(number));
}

const SlitDrawing::OnTriangle* SlitDrawing::on_triangle(std::uint32_t t) const
{
    const std::uint32_t i = triangle_number_.find(t);
    return i == KeyNumbers::none ? nullptr : &triangles_[i];
}

const std::vector<SlitDrawing::OnEdge>* SlitDrawing::on_edge(std::uint32_t edge) const
{
    const std::uint32_t i = edge_number_.find(edge);
    return i == KeyNumbers::none ? nullptr : &edges_[i];
}

SlitDrawing::OnTriangle& SlitDrawing::drawn_on(std::uint32_t t)
{
    const auto [i, fresh] = triangle_number_.number(t);
    if (fresh) {
        triangles_.emplace_back();
        drawn_triangles_.push_back(t);
    }
    return triangles_[i];
}

std::pair<std::uint32_t, bool> SlitDrawing::number_of(const LatticePoint& p)
{
    if (p.on == LatticePoint::On::point) return {p.index, false};
    const auto made = number_of_key_.insert(key_of(p), static_cast<std::uint32_t>(point_count()));
    if (!made.second) return made;
    points_.push_back(p);
    if (p.on == LatticePoint::On::triangle) {
        drawn_on(p.index).points.push_back(made.first);
        return made;
    }
    const auto [i, fresh] = edge_number_.number(p.index);
    if (fresh) edges_.emplace_back();
    edges_[i].push_back({p.b, made.first});
    for (const std::uint32_t t : triangles_round(*skin_, p)) drawn_on(t);
    return made;
}

std::uint32_t SlitDrawing::add(const DrawnChain& chain)
{
    double s = 0;
    for (std::size_t i = 0; i + 1 < chain.points.size(); ++i) {
        const std::uint32_t a = number_of(chain.points[i]).first;
        const std::uint32_t b = number_of(chain.points[i + 1]).first;
        if (a == b) continue;
        const double end = s + glm::distance(position(a), position(b));
        drawn_on(chain.triangles[i])
            .segments.push_back(static_cast<std::uint32_t>(segments_.size()));
        segments_.push_back({a, b, strokes_, s, end, chain.triangles[i]});
        s = end;
    }
    lengths_.push_back(s);
    return strokes_++;
}

std::vector<std::uint32_t> SlitDrawing::touched() const
{
    std::vector<std::uint32_t> out = drawn_triangles_;
    std::ranges::sort(out);
    return out;
}

void SlitDrawing::split(std::uint32_t segment, std::uint32_t point)
{
    const Segment g = segments_[segment];
    const double whole = glm::distance(position(g.a), position(g.b));
    const double first = glm::distance(position(g.a), position(point));
    const double share = whole > 0 ? std::min(1.0, first / whole) : 0.5;
    const double s = g.s_a + share * (g.s_b - g.s_a);
    segments_[segment] = {g.a, point, g.stroke, g.s_a, s, g.triangle};
    drawn_on(g.triangle).segments.push_back(static_cast<std::uint32_t>(segments_.size()));
    segments_.push_back({point, g.b, g.stroke, s, g.s_b, g.triangle});
}

// The points of the drawing and the corners in a triangle.
std::vector<SlitDrawing::Located> SlitDrawing::located(std::uint32_t t) const
{
    std::vector<Located> out;
    const auto add = [&](std::uint32_t number) {
        if (const auto at = weights_in(*skin_, point(number), t))
            out.push_back({number, glm::i64vec2(*at)});
    };
    for (int i = 0; i < 3; ++i) add(skin_->triangle(t)[i]);
    for (std::uint32_t i = 0; i < 3; ++i)
        if (const auto* on = on_edge(skin_->edge(3 * t + i)))
            for (const OnEdge& each : *on) add(each.point);
    if (const OnTriangle* on = on_triangle(t))
        for (const std::uint32_t p : on->points) add(p);
    return out;
}

bool SlitDrawing::split_at_points(std::uint32_t t)
{
    const std::vector<Located> points = located(t);
    const auto place = [&](std::uint32_t p) {
        return glm::i64vec2(*weights_in(*skin_, point(p), t));
    };
    bool any = false;
    for (std::size_t i = 0; i < drawn_on(t).segments.size(); ++i) {
        const std::uint32_t segment = drawn_on(t).segments[i];
        for (bool more = true; more;) {
            more = false;
            const Segment& g = segments_[segment];
            if (g.a == g.b) break;
            const glm::i64vec2 a = place(g.a), b = place(g.b);
            for (const Located& p : points) {
                if (p.point == g.a || p.point == g.b || !runs_through(a, b, p.at)) continue;
                split(segment, p.point);
                any = more = true;
                break;
            }
        }
    }
    return any;
}

// Splits the first two segments that cross. The edge of a point that is new concerns `others` too.
bool SlitDrawing::split_at_crossing(std::uint32_t t, std::vector<std::uint32_t>& others)
{
    struct Line {
        std::uint32_t segment;
        glm::i64vec2 a, b;
    };
    std::vector<Line> lines;
    const auto place = [&](std::uint32_t p) {
        return glm::i64vec2(*weights_in(*skin_, point(p), t));
    };
    for (const std::uint32_t segment : drawn_on(t).segments) {
        const Segment& g = segments_[segment];
        if (g.a != g.b) lines.push_back({segment, place(g.a), place(g.b)});
    }
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Line &k = lines[i], &l = lines[j];
            const std::int64_t la = turn_of(k.a, k.b, l.a), lb = turn_of(k.a, k.b, l.b);
            const std::int64_t ka = turn_of(l.a, l.b, k.a), kb = turn_of(l.a, l.b, k.b);
            if (la == 0 || lb == 0 || ka == 0 || kb == 0) continue;
            if ((la > 0) == (lb > 0) || (ka > 0) == (kb > 0)) continue;
            // k.a + (k.b - k.a) ka / (ka - kb), rounded and kept in the triangle
            glm::i64vec2 x = k.a;
            for (int axis = 0; axis < 2; ++axis) {
                x[axis] += rounded_quotient((k.b[axis] - k.a[axis]) * ka, ka - kb);
                x[axis] = std::clamp<std::int64_t>(x[axis], 0, lattice_steps);
            }
            if (x.x + x.y > lattice_steps) --(x.x > x.y ? x.x : x.y);
            const LatticePoint p = lattice_point(*skin_, t, glm::ivec2(x));
            const auto [number, fresh] = number_of(p);
            if (fresh) others = triangles_round(*skin_, p);
            bool any = false;
            for (const std::uint32_t segment : {k.segment, l.segment})
                if (number != segments_[segment].a && number != segments_[segment].b) {
                    split(segment, number);
                    any = true;
                }
            if (!any) throw Rejected("the cuts cross in too many places at one spot");
            return true;
        }
    return false;
}

void SlitDrawing::arrange()
{
    std::vector<std::uint32_t> first = touched();
    std::deque<std::uint32_t> open(first.begin(), first.end());
    std::vector<char> waits(triangles_.size(), 1); // by number of a drawn triangle
    const auto wait = [&](std::uint32_t t) {
        const std::uint32_t i = triangle_number_.find(t);
        waits.resize(triangles_.size(), 0);
        if (waits[i]) return;
        waits[i] = 1;
        open.push_back(t);
    };
    while (!open.empty()) {
        const std::uint32_t t = open.front();
        open.pop_front();
        waits[triangle_number_.find(t)] = 0;
        if (drawn_on(t).segments.empty()) continue;
        bool changed = true;
        for (int round = 0; changed; ++round) {
            if (round > most_rounds)
                throw Rejected("the cuts cross in too many places at one spot");
            std::vector<std::uint32_t> others;
            changed = split_at_points(t) || split_at_crossing(t, others);
            for (const std::uint32_t other : others)
                if (other != t) wait(other);
        }
    }
}

} // namespace trivar

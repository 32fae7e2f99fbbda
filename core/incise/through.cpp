// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/through.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivar {
namespace {

constexpr double seen_from_outside = 0.1; // cosine of columns with the faces that they go through
constexpr double least_crossing = 0.1;    // angle between cuts that cross
constexpr double least_way_left = 0.1;    // of the way across two columns, on the far side

glm::dvec3 position_of(const SlitSkin& skin, const SkinPlace& place)
{
    const glm::uvec3& p = skin.triangle(place.triangle);
    return place.weights.x * skin.position(p.x) + place.weights.y * skin.position(p.y) +
           place.weights.z * skin.position(p.z);
}

bool sees(const SlitSkin& skin, std::uint32_t triangle, const glm::dvec3& direction)
{
    const glm::dvec3 n = skin.area_normal(triangle);
    return glm::dot(n, direction) > seen_from_outside * glm::length(n) * glm::length(direction);
}

// Counts how often a run comes to each point; a loop comes once to the point where it closes.
void count_visits(const SlitRun& run, KeyNumbers& number, std::vector<int>& visits)
{
    for (std::size_t i = run.closed() ? 1 : 0; i <= run.last; ++i) {
        const auto [n, fresh] = number.number(run.at[i].point);
        if (fresh) visits.push_back(0);
        ++visits[n];
    }
}

// Whether some point of a run was visited more than once, or than twice where it may be crossed.
bool revisited(const SlitRun& run, const KeyNumbers& number, const std::vector<int>& visits,
               const auto& crossed)
{
    return std::ranges::any_of(run.at, [&](const SlitRun::At& at) {
        return visits[number.find(at.point)] != (crossed(at.point) ? 2 : 1);
    });
}

struct CommonPoint {
    std::uint32_t a, b; // numbers of points of both runs
};

// Ascending by a.
std::vector<CommonPoint> common_points(const SlitRun& a, const SlitRun& b)
{
    KeyNumbers number;
    for (std::uint32_t j = b.closed() ? 1 : 0; j <= b.last; ++j) number.insert(b.at[j].point, j);
    std::vector<CommonPoint> out;
    for (std::uint32_t i = a.closed() ? 1 : 0; i <= a.last; ++i)
        if (const std::uint32_t j = number.find(a.at[i].point); j != KeyNumbers::none)
            out.push_back({i, j});
    return out;
}

// Returns the sense in which two runs cross at a common point, seen along a direction: whether
// after the way on along a comes that along b, counter-clockwise. None: they do not cross cleanly
// there.
std::optional<bool> crossing_sense(const SlitDrawing& drawing, const glm::dvec3& up,
                                   const SlitRun& a, const SlitRun& b, const CommonPoint& at)
{
    if (at.a == 0 || at.a >= a.last || at.b == 0 || at.b >= b.last) return {};
    const glm::dvec3 o = drawing.position(a.at[at.a].point);
    const auto way = [&](std::uint32_t point) {
        const glm::dvec3 d = drawing.position(point) - o;
        return d - glm::dot(d, up) / glm::dot(up, up) * up;
    };
    const glm::dvec3 x = way(a.at[at.a + 1].point), y = glm::cross(glm::normalize(up), x);
    const auto angle = [&](std::uint32_t point) { // from the way on along a, 0 to 2 pi
        const glm::dvec3 d = way(point);
        const double w = std::atan2(glm::dot(d, y), glm::dot(d, x));
        return w < 0 ? w + 2 * std::numbers::pi : w;
    };
    const double back = angle(a.at[at.a - 1].point), b_on = angle(b.at[at.b + 1].point),
                 b_back = angle(b.at[at.b - 1].point);
    const double first = std::min(b_on, b_back), second = std::max(b_on, b_back);
    if (!(first > least_crossing && first < back - least_crossing &&
          second > back + least_crossing && second < 2 * std::numbers::pi - least_crossing))
        return {};
    return b_on < b_back;
}

} // namespace

FarSide far_side(const SlitRun& run, const SlitDrawing& drawing, const SlitColumns& columns)
{
    const SlitSkin& skin = drawing.skin();
    FarSide out;
    std::vector<Ray> rays;
    for (std::size_t i = 0; i <= run.last; ++i) {
        const glm::dvec3 outward = columns.outward(run.at[i].point);
        for (const std::uint32_t t : triangles_round(skin, drawing.point(run.at[i].point)))
            if (!sees(skin, t, outward))
                out.refusal = "the surface turns away from the way through";
        if (!out.refusal.empty()) return out;
        rays.push_back({drawing.position(run.at[i].point), -glm::normalize(outward)});
    }
    const auto hits = skin.opposite(rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (!hits[i] || !sees(skin, hits[i]->place.triangle, rays[i].direction)) {
            out.refusal = hits[i] ? "the other side turns away from the way through"
                                  : "no surface lies opposite";
            return out;
        }
        out.places.push_back(hits[i]->place);
        out.depths.push_back(hits[i]->distance / glm::length(columns.outward(run.at[i].point)));
    }
    for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
        const glm::dvec3 down = glm::normalize(rays[i].direction + rays[i + 1].direction);
        const auto across = [&](const glm::dvec3& way) { return way - glm::dot(way, down) * down; };
        const glm::dvec3 near = across(rays[i + 1].origin - rays[i].origin);
        const glm::dvec3 far =
            across(position_of(skin, out.places[i + 1]) - position_of(skin, out.places[i]));
        if (!(glm::dot(far, near) > least_way_left * glm::dot(near, near)))
            out.refusal = "its ways through the body cross each other";
    }
    return out;
}

std::vector<ThroughSlit::Step> zipped(const SlitSkin& skin, const std::vector<SkinPlace>& places,
                                      const SlitRun& far,
                                      const std::vector<ThroughSlit::Step>& crossings)
{
    std::vector<double> u{0}, v;
    for (std::size_t i = 1; i < places.size(); ++i)
        u.push_back(u.back() +
                    glm::distance(position_of(skin, places[i - 1]), position_of(skin, places[i])));
    for (std::size_t j = 0; j <= far.last; ++j) v.push_back(far.at[j].s / far.length);
    for (double& each : u) each /= u.back() > 0 ? u.back() : 1;
    std::vector<ThroughSlit::Step> out{{0, 0}};
    const auto n = static_cast<std::uint32_t>(u.size() - 1),
               m = static_cast<std::uint32_t>(far.last);
    auto next = crossings.begin();
    for (std::uint32_t i = 0, j = 0; i < n || j < m;) {
        while (next != crossings.end() && next->near <= i && next->far <= j) ++next;
        const std::uint32_t end_i = next != crossings.end() ? next->near : n;
        const std::uint32_t end_j = next != crossings.end() ? next->far : m;
        const bool on_near =
            j == end_j || (i < end_i && std::abs(u[i + 1] - v[j]) <= std::abs(u[i] - v[j + 1]));
        ++(on_near ? i : j);
        out.push_back({i, j});
    }
    return out;
}

std::string tangle_of(const std::vector<SlitRun>& runs, std::uint32_t near,
                      const SlitDrawing& drawing, const Inward& inward)
{
    KeyNumbers number, crossed;
    std::vector<int> visits;
    const SlitRun& run = runs[near];
    for (std::uint32_t r = 0; r <= near; ++r) {
        if (runs[r].kind != SlitRun::Kind::through) continue;
        count_visits(runs[r], number, visits);
        if (r == near) continue;
        for (const CommonPoint& at : common_points(run, runs[r])) {
            const std::uint32_t point = run.at[at.a].point;
            if (crossing_sense(drawing, inward.outward(drawing.point(point)), run, runs[r], at))
                crossed.number(point);
        }
    }
    return revisited(run, number, visits,
                     [&](std::uint32_t point) { return crossed.contains(point); })
               ? "it crosses itself or runs along another cut that goes through"
               : "";
}

std::string find_crossings(ThroughSlit& cut, const std::vector<ThroughSlit>& all,
                           const std::vector<SlitRun>& runs, const SlitDrawing& drawing,
                           const SlitColumns& columns)
{
    cut.crossings.clear();
    const SlitRun &near = runs[cut.near], &far = runs[cut.far];
    for (const ThroughSlit& other : all) {
        if (other.near == cut.near) continue;
        const auto above = common_points(near, runs[other.near]);
        const auto below = common_points(far, runs[other.far]);
        if (above.size() != below.size()) return "its other side meets that of another cut";
        for (std::size_t k = 0; k < above.size(); ++k) {
            const glm::dvec3 up = columns.outward(near.at[above[k].a].point);
            const auto near_sense = crossing_sense(drawing, up, near, runs[other.near], above[k]);
            const auto far_sense = crossing_sense(drawing, up, far, runs[other.far], below[k]);
            if (!near_sense || near_sense != far_sense)
                return "its other side meets that of another cut";
            cut.crossings.push_back({above[k].a, below[k].a});
        }
    }
    std::ranges::sort(cut.crossings, {}, &ThroughSlit::Step::near);
    for (std::size_t k = 1; k < cut.crossings.size(); ++k)
        if (cut.crossings[k].far <= cut.crossings[k - 1].far)
            return "its other side meets that of another cut";
    return "";
}

std::string unjoinable(const std::vector<SlitRun>& runs, const ThroughSlit& cut)
{
    const SlitRun &near = runs[cut.near], &far = runs[cut.far];
    if (far.last < 2 || near.closed() != far.closed())
        return "its other side is shorter than a step of the surface";
    KeyNumbers number, crossed;
    std::vector<int> visits;
    for (const SlitRun& run : runs) count_visits(run, number, visits);
    for (const ThroughSlit::Step& each : cut.crossings) crossed.number(far.at[each.far].point);
    return revisited(far, number, visits,
                     [&](std::uint32_t point) { return crossed.contains(point); })
               ? "its other side crosses a cut"
               : "";
}

} // namespace trivar

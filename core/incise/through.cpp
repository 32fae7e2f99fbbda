// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/through.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double seen_from_outside = 0.1; // cosine of columns with the faces that they go through
constexpr double least_way_left = 0.1;    // of the way across two columns, on the far side

glm::dvec3 position_of(const CutSkin& skin, const SkinPlace& place)
{
    const glm::uvec3& p = skin.triangle(place.triangle);
    return place.weights.x * skin.position(p.x) + place.weights.y * skin.position(p.y) +
           place.weights.z * skin.position(p.z);
}

bool sees(const CutSkin& skin, std::uint32_t triangle, const glm::dvec3& direction)
{
    const glm::dvec3 n = skin.area_normal(triangle);
    return glm::dot(n, direction) > seen_from_outside * glm::length(n) * glm::length(direction);
}

// How often a run comes to each point; a loop comes once to the point where it closes.
void count_visits(const CutRun& run, KeyNumbers& number, std::vector<int>& visits)
{
    for (std::size_t i = run.closed() ? 1 : 0; i <= run.last; ++i) {
        const auto [n, fresh] = number.number(run.at[i].point);
        if (fresh) visits.push_back(0);
        ++visits[n];
    }
}

// Whether some point of a run was visited more than once.
bool revisited(const CutRun& run, const KeyNumbers& number, const std::vector<int>& visits)
{
    return std::ranges::any_of(
        run.at, [&](const CutRun::At& at) { return visits[number.find(at.point)] != 1; });
}

} // namespace

FarSide far_side(const CutRun& run, const CutDrawing& drawing, const CutColumns& columns)
{
    const CutSkin& skin = drawing.skin();
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

std::vector<ThroughCut::Step> zipped(const CutSkin& skin, const std::vector<SkinPlace>& places,
                                     const CutRun& far)
{
    std::vector<double> u{0}, v;
    for (std::size_t i = 1; i < places.size(); ++i)
        u.push_back(u.back() +
                    glm::distance(position_of(skin, places[i - 1]), position_of(skin, places[i])));
    for (std::size_t j = 0; j <= far.last; ++j) v.push_back(far.at[j].s / far.length);
    for (double& each : u) each /= u.back() > 0 ? u.back() : 1;
    std::vector<ThroughCut::Step> out{{0, 0}};
    const auto n = static_cast<std::uint32_t>(u.size() - 1),
               m = static_cast<std::uint32_t>(far.last);
    for (std::uint32_t i = 0, j = 0; i < n || j < m;) {
        const bool on_near =
            j == m || (i < n && std::abs(u[i + 1] - v[j]) <= std::abs(u[i] - v[j + 1]));
        ++(on_near ? i : j);
        out.push_back({i, j});
    }
    return out;
}

std::string tangle_of(const std::vector<CutRun>& runs, std::uint32_t near)
{
    KeyNumbers number;
    std::vector<int> visits;
    for (std::uint32_t r = 0; r <= near; ++r)
        if (runs[r].kind == CutRun::Kind::through) count_visits(runs[r], number, visits);
    return revisited(runs[near], number, visits)
               ? "it crosses itself or another cut that goes through"
               : "";
}

std::string unjoinable(const std::vector<CutRun>& runs, std::uint32_t near, std::uint32_t far)
{
    if (runs[far].last < 2 || runs[near].closed() != runs[far].closed())
        return "its other side is shorter than a step of the surface";
    KeyNumbers number;
    std::vector<int> visits;
    for (const CutRun& run : runs) count_visits(run, number, visits);
    return revisited(runs[far], number, visits) ? "its other side crosses a cut" : "";
}

} // namespace trivar

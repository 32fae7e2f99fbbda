// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/letter_front.h"

#include <cmath>
#include <map>

namespace trivar {
namespace {

using RingCorners = std::vector<std::vector<int>>; // the points of each loop

// Finds the point of the next ring that belongs to a sharp corner of this ring; -1 if there is
// none. The mitre between them must be an edge, or the corner of the ring would be cut off. Its
// position is rounded on both rings.
int mitred(const std::map<std::pair<int, int>, int>& next, const Loop& loop, std::size_t i,
           double step)
{
    const std::size_t n = loop.size();
    const auto leg = [&](std::size_t a, std::size_t b) {
        return glm::normalize(glm::dvec2(loop[b]) - glm::dvec2(loop[a]));
    };
    const glm::dvec2 a = leg((i + n - 1) % n, i), b = leg(i, (i + 1) % n);
    const double cosine = glm::dot(a, b);
    if (cosine > 0.95 || cosine < -0.99) return -1;
    const glm::dvec2 inward = glm::dvec2(-a.y, a.x) + glm::dvec2(-b.y, b.x);
    const glm::ivec2 p(glm::round(glm::dvec2(loop[i]) + inward * (step / (1 + cosine))));
    constexpr int near = 3;
    for (int x = p.x - near; x <= p.x + near; ++x) {
        const auto found = next.lower_bound({x, p.y - near});
        if (found != next.end() && found->first.first == x && found->first.second <= p.y + near)
            return found->second;
    }
    return -1;
}

} // namespace

std::optional<LetterFront> letter_front(const std::vector<BevelRing>& rings, double max_edge)
{
    LetterFront front;
    Triangulation plane;
    std::vector<RingCorners> corners(rings.size());
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (const Loop& loop : rings[r].region) {
            std::vector<int>& own = corners[r].emplace_back();
            const std::vector<EdgeNormals> normals = edge_normals(loop);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int point = plane.insert(loop[i]);
                const bool fresh = static_cast<std::size_t>(point) == front.ring_of.size();
                if (!fresh && r == 0) return std::nullopt;
                if (fresh) {
                    front.ring_of.push_back(static_cast<int>(r));
                    front.at.emplace_back();
                }
                front.at[static_cast<std::size_t>(point)].push_back(normals[i]);
                own.push_back(point);
            }
        }
    std::vector<std::pair<int, int>> edges; // edges of the rim
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (const std::vector<int>& loop : corners[r])
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int a = loop[i], b = loop[(i + 1) % loop.size()];
                const Triangulation::JoinResult joined = plane.join(a, b);
                if (r > 0) continue;
                if (joined != Triangulation::JoinResult::one_edge) return std::nullopt;
                edges.emplace_back(a, b);
            }
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
        std::map<std::pair<int, int>, int> next;
        for (const std::vector<int>& loop : corners[r + 1])
            for (const int point : loop) {
                const glm::ivec2 p = plane.points()[static_cast<std::size_t>(point)];
                next[{p.x, p.y}] = point;
            }
        const double step = rings[r + 1].inset - rings[r].inset;
        for (std::size_t l = 0; l < corners[r].size(); ++l)
            for (std::size_t i = 0; i < corners[r][l].size(); ++i)
                if (const int to = mitred(next, rings[r].region[l], i, step); to >= 0)
                    plane.join(corners[r][l][i], to);
    }
    plane.fill(edges);
    const auto ring_at = [&](int point) { return front.ring_of[static_cast<std::size_t>(point)]; };
    plane.refine(
        max_edge * em_units,
        [&](const Triangulation::Corners& v) {
            return ring_at(v[0]) == ring_at(v[1]) && ring_at(v[1]) == ring_at(v[2]);
        },
        [&](int, const Triangulation::Corners& round) {
            front.ring_of.push_back(ring_at(round[0]));
            front.at.emplace_back();
        });
    front.points = plane.points();
    front.triangles = plane.inside();
    front.rim = corners[0];
    return front;
}

} // namespace trivar

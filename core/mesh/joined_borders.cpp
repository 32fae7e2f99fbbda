// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/joined_borders.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace trivar {
namespace {

constexpr double rounded_apart =
    0x1p-22; // 2 to 4 units in the last place of the largest coordinate

float largest_coordinate(const Mesh& mesh)
{
    float out = 0;
    for (const glm::vec3& p : mesh.positions)
        for (int i = 0; i < 3; ++i) out = std::max(out, std::abs(p[i]));
    return out;
}

// Numbers points from 0 in the order of their first vertices.
void renumber(std::vector<std::uint32_t>& points)
{
    constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> now(points.size(), none);
    std::uint32_t count = 0;
    for (std::uint32_t& p : points) {
        if (now[p] == none) now[p] = count++;
        p = now[p];
    }
}

// Takes back joins by which a face would come back to one of its corners: it is narrow, and no
// seam.
void keep_faces_whole(const Mesh& mesh, std::vector<std::uint32_t>& joined)
{
    std::vector<bool> apart(joined.size(), false);                // by what points would become
    std::vector<std::pair<std::uint32_t, std::uint32_t>> corners; // what it would become, and it
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        corners.clear();
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t p = mesh.point(mesh.corners[c]);
            corners.emplace_back(joined[p], p);
        }
        std::ranges::sort(corners);
        for (std::size_t i = 1; i < corners.size(); ++i)
            if (corners[i].first == corners[i - 1].first &&
                corners[i].second != corners[i - 1].second)
                apart[corners[i].first] = true;
    }
    for (std::uint32_t p = 0; p < joined.size(); ++p)
        if (apart[joined[p]]) joined[p] = p;
}

} // namespace

JoinedBorders with_joined_borders(Mesh mesh, std::vector<std::uint32_t> border)
{
    JoinedBorders out;
    std::ranges::sort(border);
    border.erase(std::unique(border.begin(), border.end()), border.end());
    const double tolerance = rounded_apart * double{largest_coordinate(mesh)};
    std::vector<glm::vec3> place(point_count(mesh)); // of the first vertex of each point
    for (auto v = static_cast<std::uint32_t>(mesh.vertex_count()); v-- > 0;)
        place[mesh.point(v)] = mesh.positions[v];

    // Along a direction that no model has, points at different places seldom lie abreast.
    const auto along = [&](std::uint32_t p) {
        return glm::dot(glm::dvec3(place[p]), glm::dvec3(0.5377, 0.7243, 0.4317));
    };
    struct Abreast {
        double along;
        std::uint32_t point;
    };
    std::vector<Abreast> sorted;
    for (const std::uint32_t p : border) sorted.push_back({along(p), p});
    std::ranges::sort(sorted, {}, [](const Abreast& a) { return std::pair(a.along, a.point); });
    std::vector<std::uint32_t> joined(place.size());
    std::iota(joined.begin(), joined.end(), 0u);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const std::uint32_t p = sorted[i].point;
        if (joined[p] != p) continue;
        constexpr std::size_t most_compared = 256; // for files that are made to be slow
        const std::size_t end = std::min(sorted.size(), i + most_compared);
        for (std::size_t j = i + 1; j < end && sorted[j].along - sorted[i].along <= 2 * tolerance;
             ++j) {
            const std::uint32_t q = sorted[j].point;
            const glm::dvec3 off = glm::abs(glm::dvec3(place[p]) - glm::dvec3(place[q]));
            if (joined[q] != q || std::max({off.x, off.y, off.z}) > tolerance) continue;
            joined[q] = p;
        }
    }
    keep_faces_whole(mesh, joined);
    for (const std::uint32_t p : border) out.any = out.any || joined[p] != p;
    out.mesh = std::move(mesh);
    if (!out.any) return out;
    std::vector<std::uint32_t> points(out.mesh.vertex_count());
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        const std::uint32_t before = out.mesh.point(v);
        points[v] = joined[before];
        if (joined[before] != before) out.mesh.positions[v] = place[joined[before]];
    }
    renumber(points);
    out.mesh.points = std::move(points);
    return out;
}

} // namespace trivar

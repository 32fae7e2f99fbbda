// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/chart.h"

#include "core/tiles/straightest.h"

#include <algorithm>
#include <limits>

namespace trivar {

TileChart chart_of(const TileBase& base, const Tile& tile, double turn_deg, double scale)
{
    const glm::dvec3 n = base.normal(tile.at);
    const double angle = glm::radians(turn_of(tile, turn_deg)), side = tile.size * scale;
    const glm::dvec3 x = std::cos(angle) * tile.x + std::sin(angle) * glm::cross(n, tile.x),
                     y = glm::cross(n, x);
    TileChart chart;
    if (!(side <= base.diagonal())) {
        chart.cut = std::numeric_limits<double>::infinity();
        return chart;
    }
    for (std::size_t k = 0; k < 16; ++k) {
        const glm::dvec3 way =
            side * ((patch_nodes[k % 4] - 0.5) * x + (patch_nodes[k / 4] - 0.5) * y);
        const SurfaceRay ray = straightest(base, tile.at, way);
        chart.nodes[k] = ray.at;
        if (!(ray.left > 0)) continue;
        chart.beyond[k] = ray.left * ray.direction;
        chart.cut = std::max(chart.cut, ray.left / side);
    }
    return chart;
}

SurfacePoint posed(const TileBase& base, const BasePose& pose, const SurfacePlace& at,
                   const glm::dvec3& beyond)
{
    const glm::uvec3& t = base.triangle(at.triangle);
    SurfacePoint out{glm::dvec3(0), glm::dvec3(0)};
    for (int c = 0; c < 3; ++c) {
        out.p += at.weights[c] * pose.points[t[c]];
        out.normal += at.weights[c] * pose.normals[t[c]];
    }
    const double length = glm::length(out.normal);
    out.normal = length > 0 ? out.normal / length : glm::dvec3(0, 0, 1);
    if (beyond == glm::dvec3(0)) return out;
    const glm::dvec3 &a = base.points()[t.x], &b = base.points()[t.y], &c = base.points()[t.z];
    const glm::dvec3 f = base.face_normal(at.triangle);
    const glm::dmat3 rest(b - a, c - a, f * glm::length(b - a));
    if (glm::determinant(rest) == 0) return out;
    const glm::dvec3 &pa = pose.points[t.x], &pb = pose.points[t.y], &pc = pose.points[t.z];
    const glm::dvec3 share = glm::inverse(rest) * beyond;
    out.p += share.x * (pb - pa) + share.y * (pc - pa);
    return out;
}

TilePatch patch_of(const TileBase& base, const BasePose& pose, const TileChart& chart)
{
    std::array<glm::dvec3, 16> p{}, n{};
    for (std::size_t k = 0; k < 16; ++k) {
        const SurfacePoint node = posed(base, pose, chart.nodes[k], chart.beyond[k]);
        p[k] = node.p;
        n[k] = node.normal;
    }
    return {through_nodes(p), through_nodes(n)};
}

} // namespace trivar

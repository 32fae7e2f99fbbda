// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/limit_chart.h"

#include "core/limit/geodesic.h"
#include "core/limit/tangent.h"

#include <algorithm>
#include <limits>

namespace trivar {
namespace {

// The share of their plane distance below which ways to neighbouring nodes are about to meet.
constexpr double least_spread = 0.3;

struct NodeWays {
    const LimitSurface& surface;
    LimitChart& chart;
    double side;

    void put(std::size_t k, const GeodesicRay& ray, double length) const
    {
        chart.nodes[k] = {surface.position(ray.at) + ray.left * ray.direction,
                          surface.normal(ray.at)};
        chart.cut = std::max(chart.cut, ray.left / side);
        if (!(ray.left > 0) && !(ray.spread > least_spread * length))
            chart.cut = std::numeric_limits<double>::infinity();
    }
};

bool is_inner(std::size_t i)
{
    return i == 1 || i == 2;
}

} // namespace

LimitChart limit_chart_of(const LimitBase& base, const Tile& tile, double turn_deg, double scale)
{
    const LimitSurface& surface = base.surface();
    const double side = tile.size * scale;
    LimitChart chart;
    if (!(side <= surface.diagonal())) {
        chart.cut = std::numeric_limits<double>::infinity();
        return chart;
    }
    const ChartPlace middle = base.place(tile.at);
    chart.piece = base.piece_of(middle.chart);
    const glm::dvec3 n = surface.normal(middle);
    const glm::dvec3 ahead =
        in_tangent_plane(turned_from_to(base.triangles().normal(tile.at), n, tile.x), n);
    const double angle = glm::radians(turn_of(tile, turn_deg));
    const glm::dvec3 x = std::cos(angle) * ahead + std::sin(angle) * glm::cross(n, ahead),
                     y = glm::cross(n, x);
    const int steps = steps_from(surface, middle, side / 2 * std::sqrt(2.0));
    const NodeWays ways{surface, chart, side};
    for (std::size_t k = 0; k < 16; ++k) {
        const std::size_t i = k % 4, j = k / 4;
        if (is_inner(i) && is_inner(j)) continue; // half-way to a corner
        const glm::dvec3 way = side * ((patch_nodes[i] - 0.5) * x + (patch_nodes[j] - 0.5) * y);
        const double length = glm::length(way);
        if (is_inner(i) || is_inner(j)) {
            ways.put(k, geodesic(surface, middle, way, steps), length);
            continue;
        }
        const int half_steps = (steps + 1) / 2;
        GeodesicRay ray = geodesic(surface, middle, way / 2.0, half_steps);
        ways.put(4 * (j > 0 ? 2 : 1) + (i > 0 ? 2 : 1), ray, length / 2);
        if (ray.left > 0) // straight on beyond the border
            ray.left += length / 2;
        else
            extend(surface, ray, length / 2, half_steps);
        ways.put(k, ray, length);
    }
    return chart;
}

} // namespace trivar

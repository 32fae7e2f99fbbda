// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/strand_chart.h"

#include "core/limit/geodesic.h"
#include "core/limit/tangent.h"
#include "core/tiles/straightest.h"

#include <algorithm>

namespace trivar {
namespace {

// The distance of the first and the last node of a cell from those next to them, in cells.
constexpr double node_gap = 0.25;

using Row = std::array<glm::dvec3, 4>;

// The cubic through four values at patch_nodes, as its control points.
Row cubic_through(const Row& values)
{
    std::array<glm::dvec3, 16> grid{};
    for (std::size_t k = 0; k < 16; ++k) grid[k] = values[k % 4];
    const std::array<glm::dvec3, 16> c = through_nodes(grid);
    return {c[0], c[1], c[2], c[3]};
}

glm::dvec3 cubic_at(const Row& c, double t)
{
    const double s = 1 - t;
    return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}

// NodeValues gives the values at the nodes of a cell's patch: points, or normals as long as the
// heights.
struct NodeValues {
    const StrandLayout& layout;
    std::span<const StrandNodes> nodes;
    std::span<const double> heights;
    bool mirrored, normals;

    glm::dvec3 at(std::uint32_t station, std::size_t j) const
    {
        const SurfacePoint& node = nodes[station][mirrored ? 3 - j : j];
        return normals ? heights[station] * node.normal : node.p;
    }
    // The change per metre at the end where two cells meet.
    glm::dvec3 rate(const StrandCell& before, const StrandCell& behind, std::size_t j) const
    {
        return (at(behind.stations[1], j) - at(before.stations[2], j)) /
               (node_gap * (before.length + behind.length));
    }
    std::array<glm::dvec3, 16> net(const StrandCell& cell) const
    {
        std::array<glm::dvec3, 16> values{};
        for (std::size_t j = 0; j < 4; ++j) {
            const Row row{at(cell.stations[0], j), at(cell.stations[1], j), at(cell.stations[2], j),
                          at(cell.stations[3], j)};
            Row c = cubic_through(row);
            const auto third = [&](int other, bool before) {
                const StrandCell& there = layout.cells[static_cast<std::size_t>(other)];
                return cell.length / 3 * (before ? rate(there, cell, j) : rate(cell, there, j));
            };
            if (cell.before >= 0) c[1] = row[0] + third(cell.before, true);
            if (cell.behind >= 0) c[2] = row[3] - third(cell.behind, false);
            values[4 * j] = row[0];
            values[4 * j + 1] = cubic_at(c, patch_nodes[1]);
            values[4 * j + 2] = cubic_at(c, patch_nodes[2]);
            values[4 * j + 3] = row[3];
        }
        return through_nodes(values);
    }
};

} // namespace

StationChart station_chart(const TileBase& base, const LimitBase* limit,
                           const StrandStation& station, double width)
{
    StationChart chart;
    const double wide = std::min(width, base.diagonal());
    const auto cut = [&](double left) { chart.cut = std::max(chart.cut, left / wide); };
    const glm::dvec3 n = base.normal(station.at);
    if (!limit) {
        const glm::dvec3 y = glm::cross(n, station.x);
        for (std::size_t j = 0; j < 4; ++j) {
            const SurfaceRay ray = straightest(base, station.at, wide * (patch_nodes[j] - 0.5) * y);
            chart.flat[j] = ray.at;
            if (!(ray.left > 0)) continue;
            chart.beyond[j] = ray.left * ray.direction;
            cut(ray.left);
        }
        chart.piece = base.piece_of(station.at.triangle);
        return chart;
    }
    const LimitSurface& surface = limit->surface();
    const ChartPlace middle = limit->place(station.at);
    chart.piece = limit->piece_of(middle.chart);
    const glm::dvec3 there = surface.normal(middle);
    const glm::dvec3 y =
        glm::cross(there, in_tangent_plane(turned_from_to(n, there, station.x), there));
    const int steps = steps_from(surface, middle, wide / 2);
    for (std::size_t j = 0; j < 4; ++j) {
        const GeodesicRay ray = geodesic(surface, middle, wide * (patch_nodes[j] - 0.5) * y, steps);
        chart.smooth[j] = {surface.position(ray.at) + ray.left * ray.direction,
                           surface.normal(ray.at)};
        cut(ray.left);
    }
    return chart;
}

TilePatch strand_patch(const StrandLayout& layout, std::size_t cell,
                       std::span<const StrandNodes> nodes, std::span<const double> heights,
                       bool mirrored)
{
    NodeValues values{layout, nodes, heights, mirrored, false};
    TilePatch patch;
    patch.p = values.net(layout.cells[cell]);
    values.normals = true;
    patch.n = values.net(layout.cells[cell]);
    return patch;
}

TilePatch part_along_x(const TilePatch& patch, double from, double to)
{
    // Control point k over [from, to]: the polar form at 3 - k times `from` and k times `to`.
    const auto part = [&](const std::array<glm::dvec3, 16>& net) {
        std::array<glm::dvec3, 16> out = net;
        for (std::size_t j = 0; j < 16; j += 4)
            for (std::size_t k = 0; k < 4; ++k) {
                if ((k == 0 && from == 0) || (k == 3 && to == 1)) continue;
                Row c{net[j], net[j + 1], net[j + 2], net[j + 3]};
                for (std::size_t step = 0; step < 3; ++step)
                    for (std::size_t i = 0; i + step < 3; ++i)
                        c[i] = glm::mix(c[i], c[i + 1], step < k ? to : from);
                out[j + k] = c[0];
            }
        return out;
    };
    return {part(patch.p), part(patch.n)};
}

std::optional<glm::dvec2> grown(const StrandCell& cell, double growth, double duration_s)
{
    if (growth >= 1) return glm::dvec2(0, 1);
    const double now = growth * duration_s, lasts = std::abs(cell.end_s - cell.begin_s),
                 since = now - std::min(cell.begin_s, cell.end_s);
    if (!(since > 0)) return {};
    const double share = lasts > 0 ? std::min(1.0, since / lasts) : 1;
    return cell.begin_s <= cell.end_s ? glm::dvec2(0, share) : glm::dvec2(1 - share, 1);
}

} // namespace trivar

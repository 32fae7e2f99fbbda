// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/split_picture.h"

namespace trivar {
namespace {

constexpr int columns = 48, rows = 24; // of the grid on a wall

// Where a side of an opening is at a share of its rectangle: on the wall, or on the cut surface.
glm::dvec3 point_on(const SplitField& field, const Opening& opening, double side,
                    const glm::dvec2& share)
{
    const OpeningWall& wall = opening.walls[side > 0 ? 1 : 0];
    const glm::dvec2 vw = glm::mix(wall.lo(), wall.hi(), share);
    const double phi = opening.surface_cells.value(vw);
    const double open =
        side == 0 || opening.beyond_walls(vw) ? 0 : opening.wall_cells[side > 0 ? 1 : 0].value(vw);
    return field.frame.world({phi + side * open, vw.x, vw.y});
}

} // namespace

std::vector<gpu::Translucent> walls_of(const SplitField& field, const ui::Theme& theme)
{
    std::vector<gpu::Translucent> out;
    for (const Opening& opening : field.openings)
        for (const double side : {-1.0, 1.0}) {
            gpu::Translucent veil;
            veil.colors = {ui::linear_light(ui::faded(theme.color.lattice, 0.16f))};
            for (int i = 0; i <= columns; ++i)
                for (int j = 0; j <= rows; ++j) {
                    veil.points.emplace_back(point_on(
                        field, opening, side, glm::dvec2(i, j) / glm::dvec2(columns, rows)));
                    if (i == 0 || j == 0) continue;
                    const auto k = static_cast<std::uint32_t>(i * (rows + 1) + j);
                    const std::uint32_t a = k - rows - 2, b = k - 1, c = k - rows - 1;
                    veil.triangles.insert(veil.triangles.end(), {a, b, k, a, k, c});
                }
            out.push_back(std::move(veil));
        }
    return out;
}

std::vector<gpu::Line> lines_of(const SplitField& field, const ui::Theme& theme)
{
    std::vector<gpu::Line> out;
    const glm::vec4 color = ui::linear_light(theme.color.incision);
    for (const Opening& opening : field.openings) {
        // The way along both walls at half their height, and the border of the cut between them
        const auto add = [&](double side, const glm::dvec2& from, const glm::dvec2& to) {
            gpu::Line line{{}, color, theme.line(side == 0 ? 1.0f : 1.6f)};
            for (int i = 0; i <= columns; ++i)
                line.points.emplace_back(
                    point_on(field, opening, side, glm::mix(from, to, i / double{columns})));
            out.push_back(std::move(line));
        };
        for (const double side : {-1.0, 1.0}) add(side, {0, 0.5}, {1, 0.5});
        for (const double end : {0.0, 1.0}) {
            add(0, {0, end}, {1, end});
            add(0, {end, 0}, {end, 1});
        }
    }
    return out;
}

} // namespace trivar

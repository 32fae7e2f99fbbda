// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/cut_picture.h"

#include "core/split/cut_sheet.h"
#include "editor/tools/split/shown_cut.h"

namespace trivar {
namespace {

constexpr int ways = 96, depths = 8;  // of the grid on a sheet
constexpr double sheet_margin = 0.06; // of what the object fills

// The points of a grid over a sheet, in the world, rows along the stroke.
std::vector<glm::dvec3> grid_on(const Cutting& cutting, std::size_t number,
                                const EvaluatedObject& object)
{
    if (!cutting.cuts[number].cuts()) return {}; // keys took it away
    const glm::dvec3 beside = shown_cut(cutting, number, object).beside;
    const CutSheet sheet(cutting.cuts[number], glm::inverse(object.own_to_world));
    glm::dvec2 lo(1e300), hi(-1e300);
    for (const glm::dvec3& corner : object.bounds->corners()) {
        const glm::dvec3 uvw = sheet.uvw(corner - beside);
        lo = glm::min(lo, glm::dvec2(uvw.y, uvw.z));
        hi = glm::max(hi, glm::dvec2(uvw.y, uvw.z));
    }
    const glm::dvec2 more = sheet_margin * (hi - lo);
    std::vector<glm::dvec3> out;
    for (int j = 0; j <= depths; ++j)
        for (int i = 0; i <= ways; ++i)
            out.push_back(beside +
                          sheet.point(glm::mix(lo - more, hi + more,
                                               glm::dvec2(static_cast<double>(i) / ways,
                                                          static_cast<double>(j) / depths))));
    return out;
}

} // namespace

std::vector<gpu::Translucent> sheets_of(const EvaluatedObject& object, const Cutting& cutting,
                                        const ui::Theme& theme)
{
    std::vector<gpu::Translucent> out;
    for (std::size_t k = 0; k < cutting.cuts.size(); ++k) {
        gpu::Translucent veil;
        veil.colors = {ui::linear_light(ui::faded(theme.color.incision, 0.14f))};
        for (const glm::dvec3& p : grid_on(cutting, k, object)) veil.points.emplace_back(p);
        if (veil.points.empty()) continue;
        for (std::uint32_t j = 0; j < depths; ++j)
            for (std::uint32_t i = 0; i < ways; ++i) {
                const std::uint32_t a = j * (ways + 1) + i, b = a + 1, c = a + ways + 1, d = c + 1;
                veil.triangles.insert(veil.triangles.end(), {a, b, d, a, d, c});
            }
        out.push_back(std::move(veil));
    }
    return out;
}

std::vector<gpu::Line> borders_of(const EvaluatedObject& object, const Cutting& cutting,
                                  const ui::Theme& theme)
{
    std::vector<gpu::Line> out;
    const glm::vec4 color = ui::linear_light(theme.color.incision);
    for (std::size_t k = 0; k < cutting.cuts.size(); ++k) {
        const std::vector<glm::dvec3> grid = grid_on(cutting, k, object);
        if (grid.empty()) continue;
        gpu::Line line{{}, color, theme.line(1.4f)};
        const auto add = [&](int i, int j) {
            line.points.emplace_back(grid[static_cast<std::size_t>(j * (ways + 1) + i)]);
        };
        for (int i = 0; i <= ways; ++i) add(i, 0);
        for (int j = 1; j <= depths; ++j) add(ways, j);
        for (int i = ways - 1; i >= 0; --i) add(i, depths);
        for (int j = depths - 1; j >= 0; --j) add(0, j);
        out.push_back(std::move(line));
    }
    return out;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/height_map_rows.h"

#include "core/placement/profile.h"
#include "editor/session/scene_facts.h"
#include "ui/height_field.h"

#include <cmath>
#include <functional>
#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

// Samples the factor at places from -1 to 1 along and across.
HeightGrid grid_of(int along, int across, const std::function<double(double, double)>& factor)
{
    HeightGrid grid;
    for (int i = 0; i < along; ++i) {
        grid.emplace_back();
        for (int j = 0; j < across; ++j)
            grid.back().push_back(
                std::round(100 * factor(2.0 * i / (along - 1) - 1, 2.0 * j / (across - 1) - 1)) /
                100);
    }
    return grid;
}

const std::vector<std::pair<std::string, HeightGrid>>& shapes()
{
    const auto bump = [](double x, double y) { return (1 - x * x) * (1 - y * y); };
    static const std::vector<std::pair<std::string, HeightGrid>> all{
        {"Even", {}},
        {"Hill", grid_of(5, 5, [&](double x, double y) { return 0.6 + 1.4 * bump(x, y); })},
        {"Hollow", grid_of(5, 5, [&](double x, double y) { return 1.3 - 1.1 * bump(x, y); })},
        {"Saddle", grid_of(5, 3, [](double x, double y) { return 1 + 0.6 * (x * x - y * y); })},
        {"Twisted", grid_of(3, 3, [](double x, double y) { return 1 + 0.6 * x * y; })},
    };
    return all;
}

ui::Edit grid_row(const ui::Theme& theme, HeightGrid& grid, int& chosen)
{
    const float width =
        ui::label_row(theme, "Points", false, "How many control points along and across.").width;
    const float gap = theme.px(4), each = std::floor((width - gap) / 2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    int along = static_cast<int>(grid.size()), across = static_cast<int>(grid.front().size());
    ui::NumberStyle style{.lo = least_map_points, .hi = most_map_points, .axis = "U"};
    const ui::Edit a = ui::integer_field(theme, "along", along, style, each);
    ImGui::SetCursorScreenPos({at.x + each + gap, at.y});
    style.axis = "V";
    const ui::Edit b = ui::integer_field(theme, "across", across, style, each);
    const ui::Edit edit = a != ui::Edit::none ? a : b;
    if (edit == ui::Edit::changed) {
        grid = resampled(grid, along, across);
        chosen = -1;
    }
    return edit;
}

} // namespace

ui::Edit draw_height_map(const ui::Theme& theme, const HeightMapRows& rows, HeightGrid& grid,
                         int& chosen)
{
    ImGui::PushID("height map");
    ui::Edit edit = ui::Edit::none;
    const auto take = [&](ui::Edit one) {
        if (one != ui::Edit::none) edit = one;
    };
    std::vector<std::string> names;
    int shape = static_cast<int>(shapes().size());
    for (const auto& [name, known] : shapes()) {
        if (known == grid) shape = static_cast<int>(names.size());
        names.push_back(name);
    }
    names.emplace_back("Custom");
    ui::Row at = ui::label_row(theme, "Height map", !grid.empty(), rows.words.help);
    const auto name_of = [&](std::size_t i, std::size_t j) {
        return rows.words.parameters.front() + "." + std::to_string(i) + "." + std::to_string(j);
    };
    std::vector<std::string> all;
    for (std::size_t i = 0; i < grid.size(); ++i)
        for (std::size_t j = 0; j < grid[i].size(); ++j) all.push_back(name_of(i, j));
    if (rows.keys && !all.empty()) rows.keys->mark(theme, at, all);
    const float whole_width = at.width;
    const bool open = ui::unfolded(theme, at, "map", !grid.empty());
    if (at.reset) {
        grid.clear();
        edit = ui::Edit::changed;
    } else if (ui::choice(theme, "shape", shape, names, at.width) == ui::Edit::changed) {
        if (shape < static_cast<int>(shapes().size()))
            grid = shapes()[static_cast<std::size_t>(shape)].second;
        else if (grid.empty())
            grid = {{1, 1, 1}, {1, 1.3, 1}, {1, 1, 1}};
        if (shape == static_cast<int>(shapes().size())) ui::unfold("map");
        chosen = -1;
        edit = ui::Edit::changed;
    }
    if (open) {
        const HeightGrid even(3, {1, 1, 1});
        HeightGrid drawn = grid.empty() ? even : grid;
        const HeightMap map(drawn);
        const bool known = rows.size_world > 0;
        const double scale = known ? rows.size_world : 1;
        const std::string unit = known ? "m" : "";
        ImGui::SetCursorScreenPos(
            {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
        take(ui::height_field(theme, "surface", drawn, chosen,
                              {.at = [&](double u, double v) { return map.at(u, v); },
                               .along = map.along(),
                               .across = map.across(),
                               .lo = least_profile,
                               .hi = most_profile,
                               .scale = scale,
                               .unit = unit,
                               .color = theme.color.lattice},
                              whole_width + theme.size.label));
        ui::tooltip({"Height map",
                     {},
                     "Drag a point of the surface, or a cell, up or down; a double click types."});
        ui::gap(theme, 4);
        take(grid_row(theme, drawn, chosen));
        const auto columns = drawn.front().size();
        const bool any = chosen >= 0 && static_cast<std::size_t>(chosen) < drawn.size() * columns;
        ui::rows_if(theme, any, "No point of the map is selected.", [&] {
            const std::size_t point = any ? static_cast<std::size_t>(chosen) : 0;
            const auto i = point / columns, j = point % columns;
            double& value = drawn[i][j];
            double size = value * scale;
            const ui::Row row =
                ui::label_row(theme, "Point", false, "The height of the selected point.");
            if (rows.keys && !grid.empty()) rows.keys->mark(theme, row, {name_of(i, j)});
            const ui::Edit typed = ui::number_field(
                theme, "point", size,
                {.lo = least_profile * scale, .hi = most_profile * scale, .unit = unit}, row.width);
            if (typed == ui::Edit::changed) value = size / scale;
            take(typed);
        });
        if (edit == ui::Edit::changed && (!grid.empty() || drawn != even)) grid = drawn;
        ui::gap(theme, 4);
    }
    ImGui::PopID();
    return edit;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/profile_rows.h"

#include "core/placement/profile.h"
#include "ui/curve_field.h"

#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

using Points = std::vector<glm::dvec2>;

const std::vector<std::pair<std::string, Points>>& shapes()
{
    static const std::vector<std::pair<std::string, Points>> all{
        {"Even", {}},
        {"Narrow at the start", {{0, 0.15}, {0.35, 1}, {1, 1}}},
        {"Narrow at the end", {{0, 1}, {0.65, 1}, {1, 0.15}}},
        {"Narrow at both ends", {{0, 0.15}, {0.3, 1}, {0.7, 1}, {1, 0.15}}},
        {"Wide in the middle", {{0, 0.6}, {0.5, 1.6}, {1, 0.6}}},
        {"Narrow in the middle", {{0, 1.2}, {0.5, 0.4}, {1, 1.2}}},
    };
    return all;
}

ui::Edit point_row(const ui::Theme& theme, Points& points, std::size_t i, double scale,
                   const std::string& unit)
{
    const float width = ui::label_row(theme, "Point", false,
                                      "Where the chosen point of the curve stands, and its size.")
                            .width;
    const float gap = theme.px(4), each = std::floor((width - gap) / 2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool end = i == 0 || i + 1 == points.size();
    constexpr double closest = 0.01;
    glm::dvec2& p = points[i];
    ui::Edit edit = ui::Edit::none;
    double place = p.x, size = p.y * scale;
    const ui::NumberStyle places{.lo = end ? p.x : points[i - 1].x + closest,
                                 .hi = end ? p.x : points[i + 1].x - closest,
                                 .axis = "U"};
    const ui::NumberStyle sizes{
        .lo = least_profile * scale, .hi = most_profile * scale, .unit = unit};
    const ui::Edit a = ui::number_field(theme, "place", place, places, each);
    if (a != ui::Edit::none) edit = a;
    ImGui::SetCursorScreenPos({at.x + each + gap, at.y});
    const ui::Edit b = ui::number_field(theme, "size", size, sizes, each);
    if (b != ui::Edit::none) edit = b;
    if (edit == ui::Edit::changed) p = {place, size / scale};
    return edit;
}

} // namespace

ui::Edit draw_profile(const ui::Theme& theme, const ProfileRows& rows, Points& points, int& chosen)
{
    ImGui::PushID(rows.label.c_str());
    ui::Edit edit = ui::Edit::none;
    std::vector<std::string> names;
    int shape = static_cast<int>(shapes().size());
    for (std::size_t i = 0; i < shapes().size(); ++i) {
        names.push_back(shapes()[i].first);
        if (shapes()[i].second == points) shape = static_cast<int>(i);
    }
    names.emplace_back("Custom");
    const ui::Row at = ui::label_row(theme, rows.label, !points.empty(), rows.help);
    if (at.reset) {
        points.clear();
        edit = ui::Edit::changed;
    } else if (ui::choice(theme, "shape", shape, names, at.width) == ui::Edit::changed) {
        if (shape < static_cast<int>(shapes().size()))
            points = shapes()[static_cast<std::size_t>(shape)].second;
        else if (points.empty())
            points = {{0, 1}, {0.5, 1.2}, {1, 1}};
        chosen = -1;
        edit = ui::Edit::changed;
    }
    if (!points.empty()) {
        const Profile profile(points);
        const bool known = rows.size_world > 0;
        const double scale = known ? rows.size_world : 1;
        const std::string unit = known ? "m" : "";
        ImGui::SetCursorScreenPos(
            {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
        const ui::Edit drawn = ui::curve_field(theme, "curve", points, chosen,
                                               {.at = [&](double t) { return profile.at(t); },
                                                .lo = least_profile,
                                                .hi = most_profile,
                                                .scale = scale,
                                                .unit = unit,
                                                .color = rows.color,
                                                .most_points = most_profile_points},
                                               at.width + theme.size.label);
        ui::tooltip({rows.label,
                     {},
                     "Drag a point; Ctrl and click adds one or takes one away, Del takes the "
                     "chosen one, a double click types."});
        if (drawn != ui::Edit::none) edit = drawn;
        ui::gap(theme, 8);
        if (chosen >= 0 && chosen < static_cast<int>(points.size())) {
            const ui::Edit typed =
                point_row(theme, points, static_cast<std::size_t>(chosen), scale, unit);
            if (typed != ui::Edit::none) edit = typed;
        }
    }
    ImGui::PopID();
    return edit;
}

} // namespace trivar

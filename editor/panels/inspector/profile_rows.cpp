// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/profile_rows.h"

#include "core/placement/profile.h"
#include "ui/curve_field.h"

#include <imgui.h>
#include <utility>

namespace trivar {
namespace {

using Points = std::vector<glm::dvec2>;

using Shapes = std::vector<std::pair<std::string, Points>>;

const Shapes& shapes(ProfileKind kind)
{
    static const Shapes along{
        {"Even", {}},
        {"Narrow at the start", {{0, 0.15}, {0.35, 1}, {1, 1}}},
        {"Narrow at the end", {{0, 1}, {0.65, 1}, {1, 0.15}}},
        {"Narrow at both ends", {{0, 0.15}, {0.3, 1}, {0.7, 1}, {1, 0.15}}},
        {"Wide in the middle", {{0, 0.6}, {0.5, 1.6}, {1, 0.6}}},
        {"Narrow in the middle", {{0, 1.2}, {0.5, 0.4}, {1, 1.2}}},
    };
    static const Shapes across{
        {"Even", {}},
        {"High in the middle", {{0, 0.4}, {0.5, 1.6}, {1, 0.4}}},
        {"Low in the middle", {{0, 1.4}, {0.5, 0.4}, {1, 1.4}}},
        {"High on the right", {{0, 1.5}, {1, 0.5}}},
        {"High on the left", {{0, 0.5}, {1, 1.5}}},
    };
    static const Shapes rise{
        {"Even", {}},
        {"Flat below", {{0, 0}, {0.5, 0.15}, {1, 1}}},
        {"Flat above", {{0, 0}, {0.5, 0.85}, {1, 1}}},
        {"Flat in the middle", {{0, 0}, {0.35, 0.45}, {0.65, 0.55}, {1, 1}}},
        {"Flat above and below", {{0, 0}, {0.35, 0.1}, {0.65, 0.9}, {1, 1}}},
    };
    switch (kind) {
    case ProfileKind::along: break;
    case ProfileKind::across: return across;
    case ProfileKind::rise: return rise;
    }
    return along;
}

std::array<std::string, 2> ends(ProfileKind kind)
{
    if (kind == ProfileKind::across) return {"right", "left"};
    if (kind == ProfileKind::rise) return {"bottom", "top"};
    return {"start", "end"};
}

// Returns the curve of "Even".
Points even(ProfileKind kind)
{
    if (kind == ProfileKind::rise) return {{0, 0}, {1, 1}};
    return {{0, 1}, {1, 1}};
}

// Where "Custom" begins.
Points custom(ProfileKind kind)
{
    if (kind == ProfileKind::rise) return {{0, 0}, {0.5, 0.4}, {1, 1}};
    return {{0, 1}, {0.5, 1.2}, {1, 1}};
}

ui::Edit point_row(const ui::Theme& theme, const ProfileRows& rows, Points& points, std::size_t i,
                   double scale, const std::string& unit)
{
    const ProfileKind kind = rows.kind;
    const ui::Row row =
        ui::label_row(theme, "Point", false, "Position and value of the selected curve point.");
    if (rows.keys)
        rows.keys->mark(theme, row,
                        axes_of(rows.words.parameters.front() + "." + std::to_string(i), 2), true);
    const float width = row.width;
    const float gap = theme.px(4), each = std::floor((width - gap) / 2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool end = i == 0 || i + 1 == points.size();
    constexpr double closest = 0.01;
    glm::dvec2& p = points[i];
    const bool rises = kind == ProfileKind::rise;
    glm::dvec2 range(least_profile, most_profile);
    if (rises)
        range = end ? glm::dvec2(p.y)
                    : glm::dvec2(points[i - 1].y + least_rise, points[i + 1].y - least_rise);
    ui::Edit edit = ui::Edit::none;
    double place = p.x, size = p.y * scale;
    const ui::NumberStyle places{.lo = end ? p.x : points[i - 1].x + closest,
                                 .hi = end ? p.x : points[i + 1].x - closest,
                                 .axis = rises                         ? "W"
                                         : kind == ProfileKind::across ? "V"
                                                                       : "U"};
    const ui::NumberStyle sizes{.lo = range.x * scale, .hi = range.y * scale, .unit = unit};
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
    const Shapes& known_shapes = shapes(rows.kind);
    int shape = static_cast<int>(known_shapes.size());
    for (std::size_t i = 0; i < known_shapes.size(); ++i) {
        names.push_back(known_shapes[i].first);
        if (known_shapes[i].second == points) shape = static_cast<int>(i);
    }
    names.emplace_back("Custom");
    ui::Row at = ui::label_row(theme, rows.label, !points.empty(), rows.words.help);
    std::vector<std::string> all; // its numbers
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::string& name :
             axes_of(rows.words.parameters.front() + "." + std::to_string(i), 2))
            all.push_back(std::move(name));
    if (rows.keys && !all.empty()) rows.keys->mark(theme, at, all);
    const float whole_width = at.width;
    const bool open = ui::unfolded(theme, at, "curve", !points.empty());
    if (at.reset) {
        points.clear();
        edit = ui::Edit::changed;
    } else if (ui::choice(theme, "shape", shape, names, at.width) == ui::Edit::changed) {
        if (shape < static_cast<int>(known_shapes.size()))
            points = known_shapes[static_cast<std::size_t>(shape)].second;
        else if (points.empty())
            points = custom(rows.kind);
        if (shape == static_cast<int>(known_shapes.size())) ui::unfold("curve");
        chosen = -1;
        edit = ui::Edit::changed;
    }
    if (open) {
        const bool rises = rows.kind == ProfileKind::rise;
        Points drawn_points = points.empty() ? even(rows.kind) : points;
        const ShareCurve curve(drawn_points);
        const bool known = rows.size_world > 0;
        const double scale = known ? rows.size_world : 1;
        const std::string unit = known ? "m" : "";
        ImGui::SetCursorScreenPos(
            {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
        const ui::Edit drawn = ui::curve_field(theme, "curve", drawn_points, chosen,
                                               {.at = [&](double t) { return curve.at(t); },
                                                .lo = least_profile,
                                                .hi = most_profile,
                                                .scale = scale,
                                                .unit = unit,
                                                .color = rows.color,
                                                .most_points = most_profile_points,
                                                .ascends = rises,
                                                .least_step = least_rise,
                                                .ends = ends(rows.kind)},
                                               whole_width + theme.size.label);
        ui::tooltip({rows.label,
                     {},
                     "Drag a point. Ctrl click adds a point or removes one, Del removes the "
                     "selected point, a double click types its numbers."});
        if (drawn != ui::Edit::none) edit = drawn;
        ui::gap(theme, 8);
        const bool any = chosen >= 0 && chosen < static_cast<int>(drawn_points.size());
        ui::rows_if(theme, any, "No point of the curve is selected.", [&] {
            const std::size_t point = any ? static_cast<std::size_t>(chosen) : 0;
            ProfileRows own = rows;
            if (points.empty()) own.keys = nullptr; // it has no points yet
            const ui::Edit typed = point_row(theme, own, drawn_points, point, scale, unit);
            if (typed != ui::Edit::none) edit = typed;
        });
        if (edit == ui::Edit::changed && (!points.empty() || drawn_points != even(rows.kind)))
            points = drawn_points;
    }
    ImGui::PopID();
    return edit;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/transfer_field.h"

#include "core/base/number_text.h"
#include "ui/held_value.h"
#include "ui/histogram.h"
#include "ui/input.h"
#include "ui/keys.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

constexpr float transfer_foot_at_1 = 22, transfer_pad_at_1 = 8, transfer_reach_at_1 = 9;
constexpr std::size_t least_transfer_points = 2;

// Between the picture and the values and opacities of points.
struct TransferPlot {
    ValueScale scale;
    glm::vec2 seen(double value, double opacity) const
    {
        const auto share = static_cast<float>(std::sqrt(std::clamp(opacity, 0.0, 1.0)));
        return {scale.x(value), scale.rect.hi.y - share * scale.rect.height()};
    }
    glm::vec2 seen(const TransferPoint& p) const { return seen(p.value, p.opacity); }
    double opacity(float y) const
    {
        const float share = std::clamp((scale.rect.hi.y - y) / scale.rect.height(), 0.0f, 1.0f);
        // Digits that people can read.
        return std::round(1e4 * static_cast<double>(share * share)) / 1e4;
    }
};

Color color_of(const glm::vec3& srgb, float alpha = 1)
{
    return ImGui::ColorConvertFloat4ToU32({srgb.r, srgb.g, srgb.b, alpha});
}

// Adds a point where the mouse is, of the colour there; its index, or -1 where there are enough.
int add_point(std::vector<TransferPoint>& points, const TransferPlot& plot, glm::vec2 mouse,
              std::size_t most)
{
    if (points.size() >= most) return -1;
    const double value = plot.scale.value(mouse.x);
    const auto after = std::ranges::upper_bound(points, value, {}, &TransferPoint::value);
    const auto added =
        points.insert(after, {value, glm::vec3(transfer_at(points, value)), plot.opacity(mouse.y)});
    return static_cast<int>(added - points.begin());
}

void drag_point(std::vector<TransferPoint>& points, std::size_t i, glm::vec2 to,
                const TransferPlot& plot)
{
    TransferPoint& p = points[i];
    const double lo = i > 0 ? points[i - 1].value : plot.scale.lo,
                 hi = i + 1 < points.size() ? points[i + 1].value : plot.scale.hi;
    p.value = std::clamp(plot.scale.value(to.x), lo, std::max(lo, hi));
    p.opacity = plot.opacity(to.y);
}

// Paints the area below the line in its colours, and the line.
void paint_function(const Theme& theme, const TransferPlot& plot,
                    const std::vector<TransferPoint>& points)
{
    const ValueScale& scale = plot.scale;
    constexpr int most_columns = 256;
    const std::array<glm::vec4, most_columns> colors = transfer_colors(points, scale.lo, scale.hi);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float each = scale.rect.width() / most_columns;
    std::vector<glm::vec2> line;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const float a = scale.rect.lo.x + static_cast<float>(i) * each;
        const double value = scale.value(a + each / 2);
        const glm::vec2 top = plot.seen(value, static_cast<double>(colors[i].a));
        draw.AddRectFilled({a, top.y}, {a + each, scale.rect.hi.y},
                           color_of(glm::vec3(colors[i]), 0.45f));
        line.push_back(top);
    }
    // Where a step is steeper than the columns are wide, the line goes through its points.
    for (const TransferPoint& p : points) line.push_back(plot.seen(p));
    std::ranges::stable_sort(line, {}, &glm::vec2::x);
    paint_path(line, theme.color.text, theme.line(1.5f));
}

void paint_points(const Theme& theme, const TransferPlot& plot,
                  const std::vector<TransferPoint>& points, int chosen, int hovered)
{
    const Palette& c = theme.color;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool lit = static_cast<int>(i) == chosen, hot = static_cast<int>(i) == hovered;
        const glm::vec2 at = plot.seen(points[i]);
        const float radius = theme.scale * (lit || hot ? 5.5f : 4.5f);
        paint_dot(at, radius + theme.size.hairline, faded(c.base, 0.9f));
        paint_dot(at, radius, color_of(points[i].color), lit ? c.accent : c.text,
                  theme.scale * (lit ? 2.0f : 1.5f));
    }
}

void paint_words(const Theme& theme, const TransferPlot& plot, const Rect& box,
                 const TransferPoint* told, const TransferStyle& style)
{
    const Rect foot{{plot.scale.rect.lo.x, plot.scale.rect.hi.y + theme.px(4)},
                    {plot.scale.rect.hi.x, box.hi.y}};
    paint_text(theme.font.small, foot, theme.color.text_3, style.ends[0], Align::left);
    paint_text(theme.font.small, foot, theme.color.text_3, style.ends[1], Align::right);
    if (!told) return;
    const std::string unit = style.unit.empty() ? "" : " " + style.unit;
    paint_text(theme.font.small, foot, theme.color.text_2,
               fmt::format("{} % at {}{}", short_number(100 * told->opacity),
                           number_text(told->value, {.digits = 6}), unit),
               Align::center);
}

} // namespace

Edit transfer_field(const Theme& theme, const std::string& id, std::vector<TransferPoint>& points,
                    int& chosen, const TransferStyle& style, float width)
{
    ImGui::PushID(id.c_str());
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID x_id = ImGui::GetID("x"), y_id = ImGui::GetID("y");
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box = rect_at({at.x, at.y}, {width, theme.px(style.height)});
    ImGui::InvisibleButton("transfer", {std::max(1.0f, width), box.height()});
    const float pad = theme.px(transfer_pad_at_1);
    const TransferPlot plot{
        {{box.lo + pad, {box.hi.x - pad, box.hi.y - theme.px(transfer_foot_at_1)}},
         style.lo,
         style.hi}};
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 mouse{io.MousePos.x, io.MousePos.y};
    const bool active = ImGui::IsItemActive(), begun = ImGui::IsItemActivated();
    const bool hovered = ImGui::IsItemHovered() || active;
    const int under = point_at(points, plot, mouse, transfer_reach_at_1 * theme.scale);
    const auto is_point = [&](int i) { return i >= 0 && i < static_cast<int>(points.size()); };
    Edit edit = Edit::none;
    bool typed = true; // a double click lets the next number be typed
    const auto remove = [&](int i) {
        if (!is_point(i) || points.size() <= least_transfer_points) return;
        points.erase(points.begin() + i);
        chosen = -1;
        edit = Edit::changed;
    };
    if (begun) {
        chosen = under;
        if (under < 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            chosen = add_point(points, plot, mouse, style.most_points);
            typed = false;
            if (chosen >= 0) edit = Edit::changed;
        }
        if (is_point(chosen)) { // from where the point is, not from where the hand is on it
            const glm::vec2 p = plot.seen(points[static_cast<std::size_t>(chosen)]);
            kept.SetFloat(x_id, p.x);
            kept.SetFloat(y_id, p.y);
        }
    } else if (active && is_point(chosen) && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
        const float fine = io.KeyShift ? 0.1f : 1.0f;
        const glm::vec2 to{kept.GetFloat(x_id) + io.MouseDelta.x * fine,
                           kept.GetFloat(y_id) + io.MouseDelta.y * fine};
        kept.SetFloat(x_id, to.x);
        kept.SetFloat(y_id, to.y);
        const std::vector<TransferPoint> before = points;
        drag_point(points, static_cast<std::size_t>(chosen), to, plot);
        if (points != before) edit = Edit::changed;
    } else if (hovered && !active && ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        remove(under);
    if (hovered && is_point(chosen)) {
        hands().keep_key(key_delete); // the last two stay: nothing else is deleted in their place
        if (!active && struck({key_delete})) remove(chosen);
    }
    edit = after_drag(edit, is_point(chosen) && typed);
    if (hovered && under >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    paint_box(box, theme.color.base, theme.size.rounding_small);
    paint_histogram(theme, plot.scale, style.counts);
    ImGui::PushClipRect({box.lo.x, box.lo.y}, {box.hi.x, box.hi.y}, true);
    paint_function(theme, plot, points);
    const int hot = hovered && !active ? under : -1;
    paint_points(theme, plot, points, chosen, hot);
    ImGui::PopClipRect();
    const int told = is_point(hot) ? hot : chosen;
    paint_words(theme, plot, box,
                is_point(told) ? &points[static_cast<std::size_t>(told)] : nullptr, style);
    ImGui::PopID();
    return edit;
}

} // namespace trivar::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_field.h"

#include "ui/held_value.h"
#include "ui/histogram.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar::ui {
namespace {

constexpr float levels_foot_at_1 = 22, grip_reach_at_1 = 7, levels_pad_at_1 = 8;
constexpr float snap_reach_at_1 = 6, above_curve_at_1 = 5;

// The bars, and the curve in the strip below them; marks reach down to the foot of both.
struct LevelPlot {
    ValueScale scale; // of the bars
    float foot = 0;   // y, pixels
    float tall = 0;   // of the curve, pixels
};

// The points of the curve in the picture. Its heights are shown by their roots, so that what is low
// beside a peak has a shape still.
std::vector<glm::vec2> seen_curve(const LevelPlot& plot, std::span<const glm::dvec2> curve)
{
    double most = 1e-300;
    for (const glm::dvec2& p : curve) most = std::max(most, p.y);
    std::vector<glm::vec2> out;
    for (const glm::dvec2& p : curve) {
        const auto share = static_cast<float>(std::sqrt(std::max(0.0, p.y) / most));
        out.emplace_back(plot.scale.x(p.x), plot.foot - share * plot.tall);
    }
    return out;
}

void paint_curve(const Theme& theme, const LevelPlot& plot, const std::vector<glm::vec2>& path)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 1; i < path.size(); ++i)
        draw.AddQuadFilled({path[i - 1].x, path[i - 1].y}, {path[i].x, path[i].y},
                           {path[i].x, plot.foot}, {path[i - 1].x, plot.foot},
                           faded(theme.color.text_3, 0.15f));
    if (path.size() > 1) paint_path(path, theme.color.text_3, theme.line(1));
}

// A dot on the curve where values snap; those that a mark has are lit.
void paint_snaps(const Theme& theme, const LevelPlot& plot, const LevelStyle& style,
                 const std::vector<glm::vec2>& path, const std::vector<LevelMark>& marks)
{
    for (const double at : style.snaps) {
        const auto after = std::ranges::lower_bound(style.curve, at, {}, &glm::dvec2::x);
        if (after == style.curve.end()) continue;
        const glm::vec2 place = path[static_cast<std::size_t>(after - style.curve.begin())];
        const bool lit = std::ranges::any_of(marks, [&](const LevelMark& mark) {
            return std::abs(mark.value - at) < 0.5 * plot.scale.per_px();
        });
        if (lit)
            paint_dot(place, theme.scale * 3.5f, theme.color.accent, theme.color.text,
                      1.5f * theme.scale);
        else
            paint_dot(place, theme.scale * 2.5f, theme.color.text_2);
    }
}

// Returns the brightness of a colour, 0 to 1.
float brightness(Color color)
{
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
    return 0.3f * c.x + 0.59f * c.y + 0.11f * c.z;
}

void paint_mark(const Theme& theme, const LevelPlot& plot, const LevelMark& mark, bool lit)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float x = std::round(plot.scale.x(mark.value)), y = plot.foot;
    const float top = plot.scale.rect.lo.y - theme.px(4);
    const float half = theme.px(5), wide = std::max(1.0f, std::round(theme.px(lit ? 2 : 1)));
    const Color color = mark.dim ? faded(mark.color, 0.45f) : mark.color;
    // A rim like the ground parts the line from the bars; one that is itself like the ground has
    // one like the words.
    constexpr float alike = 0.25f;
    const bool lost = std::abs(brightness(mark.color) - brightness(theme.color.base)) < alike;
    const Color rim = faded(lost ? theme.color.text_2 : theme.color.base, 0.9f);
    const float left = x - std::floor(wide / 2);
    paint_box({{left - theme.size.hairline, top}, {left + wide + theme.size.hairline, y}}, rim);
    paint_box({{left, top}, {left + wide, y}}, color);
    draw.AddTriangleFilled({x - half, y + theme.px(8)}, {x, y}, {x + half, y + theme.px(8)}, color);
    if (lit || lost)
        draw.AddTriangle({x - half, y + theme.px(8)}, {x, y}, {x + half, y + theme.px(8)},
                         lit ? theme.color.text : theme.color.text_2, 1.5f * theme.scale);
}

// The words of the chosen mark first; others where they do not touch those.
void paint_words(const Theme& theme, const LevelPlot& plot, const Rect& box,
                 const std::vector<LevelMark>& marks, int chosen, const LevelStyle& style)
{
    const ValueScale& scale = plot.scale;
    std::vector<Rect> taken;
    const float top = plot.foot + theme.px(6), bottom = box.hi.y;
    const auto write = [&](float left, const std::string& words, Color color) {
        const float wide = text_width(theme.font.small, words);
        left = std::clamp(left, box.lo.x + theme.px(4), box.hi.x - theme.px(4) - wide);
        const Rect r{{std::round(left), top}, {std::round(left) + wide, bottom}};
        const Rect apart = r.grown(theme.px(3));
        if (std::ranges::any_of(taken, [&](const Rect& other) {
                return other.lo.x < apart.hi.x && apart.lo.x < other.hi.x;
            }))
            return;
        paint_text(theme.font.small, r, color, words);
        taken.push_back(r);
    };
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < marks.size(); ++i) order.push_back(i);
    if (chosen >= 0 && chosen < static_cast<int>(order.size()))
        std::swap(order[0], order[static_cast<std::size_t>(chosen)]);
    for (const std::size_t i : order) // their grips are no place for words
        taken.push_back({{scale.x(marks[i].value) - theme.px(5), top},
                         {scale.x(marks[i].value) + theme.px(5), bottom}});
    for (const std::size_t i : order) {
        const float x = scale.x(marks[i].value),
                    wide = text_width(theme.font.small, marks[i].words);
        const bool right = x + theme.px(9) + wide < box.hi.x - theme.px(4);
        write(right ? x + theme.px(9) : x - theme.px(9) - wide, marks[i].words,
              static_cast<int>(i) == chosen ? theme.color.text : theme.color.text_2);
    }
    write(scale.rect.lo.x, style.ends[0], theme.color.text_3);
    write(scale.rect.hi.x - text_width(theme.font.small, style.ends[1]), style.ends[1],
          theme.color.text_3);
}

int mark_at(const std::vector<LevelMark>& marks, const ValueScale& scale, float x, float reach)
{
    int nearest = -1;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const float distance = std::abs(scale.x(marks[i].value) - x);
        if (distance > reach) continue;
        reach = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

} // namespace

double snapped(std::span<const double> to, double value, double reach)
{
    double out = value;
    for (const double each : to)
        if (const double off = std::abs(each - value); off <= reach) {
            reach = off;
            out = each;
        }
    return out;
}

Edit level_field(const Theme& theme, const std::string& id, std::vector<LevelMark>& marks,
                 int& chosen, const LevelStyle& style, float width)
{
    ImGui::PushID(id.c_str());
    const ImGuiID value_id = ImGui::GetID("value");
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box = rect_at({at.x, at.y}, {width, theme.px(style.height)});
    ImGui::InvisibleButton("levels", {std::max(1.0f, width), box.height()});
    const float pad = theme.px(levels_pad_at_1), foot = box.hi.y - theme.px(levels_foot_at_1);
    const float strip = theme.px(style.strip);
    const ValueScale scale{
        {{box.lo.x + pad, box.lo.y + pad}, {box.hi.x - pad, foot - strip}}, style.lo, style.hi};
    const LevelPlot plot{scale, foot, std::max(0.0f, strip - theme.px(above_curve_at_1))};
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    const int under =
        style.fixed ? -1 : mark_at(marks, scale, io.MousePos.x, grip_reach_at_1 * theme.scale);
    Edit edit = Edit::none;
    if (ImGui::IsItemActivated() && !style.fixed) {
        if (under >= 0) chosen = under;
        kept.SetBool(ImGui::GetID("held"), under >= 0);
        if (under >= 0) // from where the value is, not from where the hand is on it
            kept.SetFloat(value_id, scale.x(marks[static_cast<std::size_t>(under)].value));
    }
    const bool held = kept.GetBool(ImGui::GetID("held")) && chosen >= 0 &&
                      chosen < static_cast<int>(marks.size());
    if (active && held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2) &&
        io.MouseDelta.x != 0) {
        const double fine = io.KeyShift ? 0.1 : 1;
        const float to = kept.GetFloat(value_id) + io.MouseDelta.x * static_cast<float>(fine);
        kept.SetFloat(value_id, to);
        LevelMark& mark = marks[static_cast<std::size_t>(chosen)];
        double value = scale.value(to);
        if (!io.KeyCtrl)
            value = snapped(style.snaps, value, theme.px(snap_reach_at_1) * fine * scale.per_px());
        if (value != mark.value) edit = Edit::changed;
        mark.value = value;
    }
    edit = after_drag(edit, held);
    if ((hovered && under >= 0) || (active && held))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    paint_box(box, theme.color.base, theme.size.rounding_small);
    paint_histogram(theme, scale, style.counts);
    const std::vector<glm::vec2> path = seen_curve(plot, style.curve);
    paint_curve(theme, plot, path);
    const auto lit = [&](std::size_t i) {
        const int n = static_cast<int>(i);
        return !style.fixed && (n == chosen || (hovered && !active && n == under));
    };
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (!lit(i)) paint_mark(theme, plot, marks[i], false);
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (lit(i)) paint_mark(theme, plot, marks[i], true);
    paint_snaps(theme, plot, style, path, marks);
    paint_words(theme, plot, box, marks, chosen, style);
    ImGui::PopID();
    return edit;
}

} // namespace trivar::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_field.h"

#include "ui/held_value.h"
#include "ui/paint.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar::ui {
namespace {

constexpr float levels_foot_at_1 = 22, grip_reach_at_1 = 7, levels_pad_at_1 = 8;

struct Scale {
    Rect rect; // of the bars
    double lo = 0, hi = 1;
    float x(double value) const
    {
        const double share = hi > lo ? std::clamp((value - lo) / (hi - lo), 0.0, 1.0) : 0.5;
        return rect.lo.x + static_cast<float>(share) * rect.width();
    }
};

// Bars of whole pixels, each of several parts where the field is narrow.
void paint_bars(const Theme& theme, const Scale& scale, const LevelStyle& style)
{
    if (style.counts.empty()) return;
    const float pitch = std::max(2.0f, std::round(theme.px(3))), gap = theme.size.hairline;
    const int bars = std::max(1, static_cast<int>(scale.rect.width() / pitch));
    std::vector<double> heights(static_cast<std::size_t>(bars), 0);
    for (std::size_t i = 0; i < style.counts.size(); ++i) {
        const auto bar = i * heights.size() / style.counts.size();
        heights[bar] += static_cast<double>(style.counts[i]);
    }
    // Where there are more bars than parts each part has several.
    if (heights.size() > style.counts.size())
        for (std::size_t bar = 0; bar < heights.size(); ++bar)
            heights[bar] =
                static_cast<double>(style.counts[bar * style.counts.size() / heights.size()]);
    double most = 0;
    for (double& height : heights) {
        height = std::log1p(height);
        most = std::max(most, height);
    }
    if (most <= 0) return;
    const float each = scale.rect.width() / static_cast<float>(bars);
    for (std::size_t bar = 0; bar < heights.size(); ++bar) {
        const float tall = static_cast<float>(heights[bar] / most) * scale.rect.height();
        const float a = std::round(scale.rect.lo.x + static_cast<float>(bar) * each),
                    b = std::round(scale.rect.lo.x + static_cast<float>(bar + 1) * each) - gap;
        if (tall > 0)
            paint_box(
                {{a, std::round(scale.rect.hi.y - std::max(1.0f, tall))}, {b, scale.rect.hi.y}},
                theme.color.text_off);
    }
}

void paint_mark(const Theme& theme, const Scale& scale, const LevelMark& mark, bool lit)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float x = std::round(scale.x(mark.value)), y = scale.rect.hi.y;
    const float half = theme.px(5), wide = std::max(1.0f, std::round(theme.px(lit ? 2 : 1)));
    const Color color = mark.dim ? faded(mark.color, 0.45f) : mark.color;
    // A dark rim, so that dark colours show on the bars and light ones on light bars.
    const Color rim = faded(theme.color.base, 0.9f);
    const float left = x - std::floor(wide / 2);
    paint_box({{left - theme.size.hairline, scale.rect.lo.y - theme.px(4)},
               {left + wide + theme.size.hairline, y}},
              rim);
    paint_box({{left, scale.rect.lo.y - theme.px(4)}, {left + wide, y}}, color);
    draw.AddTriangleFilled({x - half, y + theme.px(8)}, {x, y}, {x + half, y + theme.px(8)}, color);
    if (lit)
        draw.AddTriangle({x - half, y + theme.px(8)}, {x, y}, {x + half, y + theme.px(8)},
                         theme.color.text, 1.5f * theme.scale);
}

// The words of the chosen mark first; others where they do not touch those.
void paint_words(const Theme& theme, const Scale& scale, const Rect& box,
                 const std::vector<LevelMark>& marks, int chosen, const LevelStyle& style)
{
    std::vector<Rect> taken;
    const float top = scale.rect.hi.y + theme.px(6), bottom = box.hi.y;
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

int mark_at(const std::vector<LevelMark>& marks, const Scale& scale, float x, float reach)
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

Edit level_field(const Theme& theme, const std::string& id, std::vector<LevelMark>& marks,
                 int& chosen, const LevelStyle& style, float width)
{
    ImGui::PushID(id.c_str());
    const ImGuiID value_id = ImGui::GetID("value");
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box = rect_at({at.x, at.y}, {width, theme.px(style.height)});
    ImGui::InvisibleButton("levels", {std::max(1.0f, width), box.height()});
    const float pad = theme.px(levels_pad_at_1);
    const Scale scale{
        {{box.lo.x + pad, box.lo.y + pad}, {box.hi.x - pad, box.hi.y - theme.px(levels_foot_at_1)}},
        style.lo,
        style.hi};
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
        const float to = kept.GetFloat(value_id) + io.MouseDelta.x * (io.KeyShift ? 0.1f : 1.0f);
        kept.SetFloat(value_id, to);
        const double share = static_cast<double>((to - scale.rect.lo.x) / scale.rect.width());
        LevelMark& mark = marks[static_cast<std::size_t>(chosen)];
        const double value =
            std::clamp(style.lo + share * (style.hi - style.lo), style.lo, style.hi);
        if (value != mark.value) edit = Edit::changed;
        mark.value = value;
    }
    edit = after_drag(edit, held);
    if ((hovered && under >= 0) || (active && held))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    paint_box(box, theme.color.base, theme.size.rounding_small);
    paint_bars(theme, scale, style);
    const auto lit = [&](std::size_t i) {
        const int n = static_cast<int>(i);
        return !style.fixed && (n == chosen || (hovered && !active && n == under));
    };
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (!lit(i)) paint_mark(theme, scale, marks[i], false);
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (lit(i)) paint_mark(theme, scale, marks[i], true);
    paint_words(theme, scale, box, marks, chosen, style);
    ImGui::PopID();
    return edit;
}

} // namespace trivar::ui

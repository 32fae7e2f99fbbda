// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/icons.h"
#include "ui/keys.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace {

// The whole width of the panel, whatever its padding: rows place themselves.
Rect row_rect(float height)
{
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetWindowPos().x;
    return rect_at({left, at.y}, {ImGui::GetWindowWidth(), height});
}

ImGuiID reset_key()
{
    return ImHashStr("the frame in which rows are reset");
}

} // namespace

void reset_rows()
{
    ImGui::GetStateStorage()->SetInt(reset_key(), ImGui::GetFrameCount());
}

bool section(const Theme& theme, const std::string& title, bool open_at_first,
             const std::string& note, Color note_color)
{
    const Palette& c = theme.color;
    const Rect r = row_rect(theme.size.group);
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(title.c_str());
    const bool open = storage.GetBool(id, open_at_first);
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    if (ImGui::InvisibleButton(title.c_str(), {r.width(), r.height()})) storage.SetBool(id, !open);
    paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, c.line);
    if (ImGui::IsItemHovered())
        paint_box({r.lo + glm::vec2(0, theme.size.hairline), r.hi}, c.row_hover);
    const Rect inside = {r.lo + glm::vec2(theme.size.padding, 1),
                         r.hi - glm::vec2(theme.size.padding, -1)};
    paint_text(theme.font.body, inside, c.text_2, open ? icon::open : icon::closed);
    paint_text(theme.font.strong, {inside.lo + glm::vec2(theme.px(16), 0), inside.hi}, c.text,
               title);
    paint_text(theme.font.small, inside, note_color ? note_color : c.text_3, note, Align::right);
    if (open) gap(theme, 2);
    return open;
}

Row label_row(const Theme& theme, const std::string& label, bool changed, const std::string& help)
{
    const Palette& c = theme.color;
    const Rect r = row_rect(theme.size.row);
    Row row;
    const float x = r.lo.x + theme.size.padding;
    ImGui::PushID(label.c_str());
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    if (changed) {
        row.reset = ImGui::InvisibleButton("reset", {theme.size.padding, theme.size.row});
        const bool hot = ImGui::IsItemHovered();
        paint_dot({x - theme.px(6), r.center().y}, theme.px(hot ? 3 : 2), c.changed);
        tooltip({"Reset to the default", "Backspace"});
        const bool over = ImGui::IsWindowHovered() &&
                          ImGui::IsMouseHoveringRect({r.lo.x, r.lo.y}, {r.hi.x, r.hi.y});
        row.reset = row.reset ||
                    (over && !ImGui::IsAnyItemActive() && struck({.key = key_backspace})) ||
                    ImGui::GetStateStorage()->GetInt(reset_key(), -1) == ImGui::GetFrameCount();
    }
    const float room = theme.size.label - theme.px(8);
    // A long label is smaller rather than cut.
    const bool long_one = text_width(theme.font.body, label) > room;
    const ImFont* font = long_one ? theme.font.small : theme.font.body;
    const std::string shown = elided(font, label, room);
    if (!help.empty() || shown != label)
        tooltip_in({{x, r.lo.y}, {r.hi.x - theme.px(16), r.hi.y}}, {label, {}, help});
    ImGui::PopID();
    paint_text(font, {{x, r.lo.y}, r.hi}, c.text_2, shown);
    ImGui::SetCursorScreenPos({x + theme.size.label, r.lo.y});
    row.width = r.hi.x - theme.px(key_gutter) - (x + theme.size.label);
    return row;
}

void fact_row(const Theme& theme, const std::string& label, const std::string& value, Color color,
              const std::string& help)
{
    const Row row = label_row(theme, label, false, help);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({std::max(1.0f, row.width), theme.size.row});
    const std::string shown = elided(theme.font.body, value, row.width);
    if (shown != value) tooltip({value, {}, help});
    paint_text(theme.font.body, rect_at({at.x, at.y}, {row.width, theme.size.row}),
               color ? color : theme.color.text, shown);
}

void gap(const Theme& theme, float height_at_scale_1)
{
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    ImGui::Dummy({1, std::max(0.0f, theme.px(height_at_scale_1) - spacing)});
}

void empty_state(const Theme& theme, const Rect& in, const char* icon, const std::string& title,
                 const std::string& body)
{
    const Palette& c = theme.color;
    const float line = theme.px(20);
    const float width = std::min(theme.px(232), in.width() - theme.px(32));
    const std::vector<std::string> lines = wrapped(theme.font.body, body, width);
    const float height = theme.px(68) + line * static_cast<float>(lines.size());
    const bool cramped = height > in.height(); // then words go before the icon
    const float shown = cramped ? height - theme.px(40) : height;
    float y = std::round(std::max(in.lo.y, in.center().y - shown / 2));
    const auto band = [&](float h) {
        const Rect r{{in.lo.x, y}, {in.hi.x, y + h}};
        y += h;
        return r;
    };
    if (!cramped)
        paint_text(theme.font.large_icon, band(theme.px(40)), c.text_off, icon, Align::center);
    paint_text(theme.font.strong, band(theme.px(28)), c.text_2, title, Align::center);
    for (const std::string& words : lines)
        paint_text(theme.font.body, band(line), c.text_3, words, Align::center);
}

} // namespace trivar::ui

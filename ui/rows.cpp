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

bool is_greyed()
{
    return (GImGui->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0;
}

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
    if (open_at_first && storage.GetInt(id, -1) < 0) storage.SetBool(id, true); // and stays open
    const bool open = storage.GetBool(id, false);
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
        row.reset =
            row.reset ||
            (over && !is_greyed() && !ImGui::IsAnyItemActive() && struck({.key = key_backspace})) ||
            ImGui::GetStateStorage()->GetInt(reset_key(), -1) == ImGui::GetFrameCount();
    }
    const float room = theme.size.label - theme.px(8);
    // A long label is smaller rather than cut.
    const bool long_one = text_width(theme.font.body, label) > room;
    const ImFont* font = long_one ? theme.font.small : theme.font.body;
    const std::string shown = elided(font, label, room);
    if (!help.empty() || shown != label || is_greyed())
        tooltip_in({{x, r.lo.y}, {r.hi.x - theme.px(16), r.hi.y}}, {label, {}, help});
    ImGui::PopID();
    paint_text(font, {{x, r.lo.y}, r.hi}, c.text_2, shown);
    ImGui::SetCursorScreenPos({x + theme.size.label, r.lo.y});
    row.width = r.hi.x - theme.px(key_gutter) - (x + theme.size.label);
    return row;
}

bool unfolded(const Theme& theme, Row& row, const std::string& id, bool open_at_first)
{
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID kept = ImGui::GetID(("unfolded " + id).c_str());
    if (storage.GetInt(kept, -1) < 0) storage.SetBool(kept, open_at_first);
    const bool open = storage.GetBool(kept);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = theme.size.row;
    row.width -= side + theme.px(2);
    ImGui::SetCursorScreenPos({at.x + row.width + theme.px(2), at.y});
    if (icon_button(theme, "unfold " + id, open ? icon::open : icon::closed, {side, side},
                    {open ? "Hide the curve" : "Show the curve", {}, {}}))
        storage.SetBool(kept, !open);
    ImGui::SetCursorScreenPos(at);
    return open;
}

void unfold(const std::string& id)
{
    ImGui::GetStateStorage()->SetBool(ImGui::GetID(("unfolded " + id).c_str()), true);
}

void fact_row(const Theme& theme, const std::string& label, const std::string& value, Color color,
              const std::string& help)
{
    const Row row = label_row(theme, label, false, help);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({std::max(1.0f, row.width), theme.size.row});
    const bool long_one = text_width(theme.font.body, value) > row.width;
    const ImFont* font = long_one ? theme.font.small : theme.font.body;
    const std::string shown = elided(font, value, row.width);
    if (shown != value) tooltip({value, {}, help});
    paint_text(font, rect_at({at.x, at.y}, {row.width, theme.size.row}),
               color ? color : theme.color.text, shown);
}

std::optional<int> list_row(const Theme& theme, const ListRow& row,
                            const std::vector<RowButton>& buttons)
{
    const float side = theme.size.row, edge = theme.size.padding;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width =
        ImGui::GetContentRegionAvail().x - side * static_cast<float>(buttons.size()) - theme.px(8);
    std::optional<int> pressed;
    if (row.tip) {
        if (ImGui::InvisibleButton("name", {std::max(1.0f, width), side})) pressed = -1;
        tooltip(*row.tip);
    }
    Rect words = rect_at({at.x + edge, at.y}, {width - edge, side});
    if (row.icon) {
        paint_text(theme.font.body, words, theme.color.text_3, row.icon);
        words.lo.x += theme.px(16);
    }
    name_text(row.font ? row.font : theme.font.body, words,
              row.color ? row.color : theme.color.text, row.name);
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        ImGui::SetCursorScreenPos(
            {at.x + width + theme.px(4) + side * static_cast<float>(i), at.y});
        if (icon_button(theme, buttons[i].id, buttons[i].icon, {side, side}, buttons[i].tip))
            pressed = static_cast<int>(i);
    }
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(2)});
    ImGui::Dummy({1, 0});
    return pressed;
}

void rows_if(const Theme& theme, bool they_apply, const char* why_not,
             const std::function<void()>& draw)
{
    if (they_apply || is_greyed()) return draw(); // greyed ones are not greyed again
    const Rect first = row_rect(0);
    ImGui::BeginDisabled();
    tooltips().grey(why_not);
    draw();
    tooltips().grey({});
    ImGui::EndDisabled();
    paint_box({first.lo, {first.hi.x, ImGui::GetCursorScreenPos().y}},
              faded(theme.color.panel, 0.6f));
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets.h"

#include "ui/icons.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

namespace trivar::ui {
namespace {

glm::vec2 cursor()
{
    const ImVec2 p = ImGui::GetCursorScreenPos();
    return {p.x, p.y};
}

struct PressState {
    Rect rect;
    bool hovered = false, held = false, clicked = false;
};
PressState press_area(const std::string& id, glm::vec2 size)
{
    PressState p;
    p.rect = rect_at(cursor(), size);
    p.clicked =
        ImGui::InvisibleButton(id.c_str(), {std::max(1.0f, size.x), std::max(1.0f, size.y)});
    p.hovered = ImGui::IsItemHovered();
    p.held = ImGui::IsItemActive();
    return p;
}

ImGuiID command_key()
{
    return ImHashStr("fields set commands");
}

// Opens the menu of commands on the right button over the last item, if its window offers them.
Edit command_menu(const std::string& id)
{
    if (!offers_commands()) return Edit::none;
    ImGui::PushID(id.c_str());
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("field menu");
    Edit edit = Edit::none;
    if (ImGui::BeginPopup("field menu")) {
        if (ImGui::MenuItem(copy_command_words)) edit = Edit::copied;
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return edit;
}

float to_srgb(float c)
{
    return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}
float to_linear(float c)
{
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

} // namespace

void offer_commands()
{
    ImGui::GetStateStorage()->SetBool(command_key(), true);
}

bool offers_commands()
{
    return ImGui::GetStateStorage()->GetBool(command_key());
}

Edit check_box(const Theme& theme, const std::string& id, bool& value, const std::string& effect)
{
    const Palette& c = theme.color;
    const float side = theme.px(16);
    const float beside = side + theme.px(8);
    const float width = beside + text_width(theme.font.body, effect);
    const std::string words =
        elided(theme.font.body, effect, ImGui::GetContentRegionAvail().x - beside);
    const PressState p = press_area(id, {width, theme.size.row});
    const Rect box = rect_at({p.rect.lo.x, p.rect.lo.y + theme.px(4)}, glm::vec2(side));
    paint_box(box, value ? (p.hovered ? c.accent_hover : c.accent) : c.field_hover,
              theme.size.rounding_small);
    if (!value)
        paint_rim(box, p.hovered ? c.focus : c.text_off, theme.size.rounding_small,
                  theme.size.hairline);
    if (value) {
        const auto at = [&](float x, float y) { return box.lo + glm::vec2(x, y) * theme.scale; };
        paint_path({at(4, 8), at(7, 11), at(12, 5)}, c.on_accent, 1.8f * theme.scale);
    }
    paint_text(theme.font.body, {{box.hi.x + theme.px(8), p.rect.lo.y}, p.rect.hi}, c.text, words);
    if (words != effect) tooltip({effect});
    if (!p.clicked) return command_menu(id);
    value = !value;
    return Edit::changed;
}

Edit segments(const Theme& theme, const std::string& id, int& chosen,
              const std::vector<std::string>& names, float width)
{
    const Palette& c = theme.color;
    const float each = width / static_cast<float>(names.size());
    const auto fit = [&](const ImFont* font, float apart) {
        return std::ranges::all_of(names, [&](const std::string& name) {
            return text_width(font, name) + theme.px(apart) < each;
        });
    };
    const ImFont* font = fit(theme.font.body, 10) ? theme.font.body : theme.font.small;
    if (!fit(font, 6)) return choice(theme, id, chosen, names, width);
    const PressState p = press_area(id, {width, theme.size.row});
    paint_box(p.rect, c.field, theme.size.rounding_small);
    const float mouse = ImGui::GetIO().MousePos.x - p.rect.lo.x;
    const int under = p.hovered ? static_cast<int>(mouse / each) : -1;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto k = static_cast<float>(i);
        const Rect one{{std::round(p.rect.lo.x + k * each), p.rect.lo.y},
                       {std::round(p.rect.lo.x + (k + 1) * each), p.rect.hi.y}};
        const bool on = static_cast<int>(i) == chosen, hot = static_cast<int>(i) == under;
        if (on) paint_box(one.grown(-theme.px(2)), c.segment, theme.px(3));
        paint_text(font, one, on || hot ? c.text : c.text_2, names[i], Align::center);
    }
    const int last = static_cast<int>(names.size()) - 1;
    if (!p.clicked || std::clamp(under, 0, last) == chosen) return command_menu(id);
    chosen = std::clamp(under, 0, last);
    return Edit::changed;
}

Edit choice(const Theme& theme, const std::string& id, int& chosen,
            const std::vector<std::string>& names, float width)
{
    const Palette& c = theme.color;
    ImGui::PushID(id.c_str());
    const PressState p = press_area("open", {width, theme.size.row});
    paint_box(p.rect, p.hovered ? c.field_hover : c.field, theme.size.rounding_small);
    Rect text = {p.rect.lo + glm::vec2(theme.px(8), 0), p.rect.hi - glm::vec2(theme.px(8), 0)};
    paint_text(theme.font.body, text, c.text_2, icon::open, Align::right);
    text.hi.x -= theme.px(16);
    const bool known = chosen >= 0 && chosen < static_cast<int>(names.size());
    const std::string shown = known ? names[static_cast<std::size_t>(chosen)] : "";
    const std::string fits = elided(theme.font.body, shown, text.width());
    paint_text(theme.font.body, text, c.text, fits);
    Edit edit = command_menu("command");
    if (fits != shown) tooltip({shown});
    if (p.clicked) ImGui::OpenPopup("list");
    const float gap = theme.px(4);
    const float tall = theme.size.row * static_cast<float>(names.size()) + 2 * gap;
    const bool below = p.rect.hi.y + gap + tall <= ImGui::GetIO().DisplaySize.y ||
                       tall + gap > p.rect.lo.y; // else above
    ImGui::SetNextWindowPos({p.rect.lo.x, below ? p.rect.hi.y + gap : p.rect.lo.y - gap - tall});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(4), theme.px(4)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    if (ImGui::BeginPopup("list")) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const Rect row = rect_at({at.x, at.y}, {width - theme.px(8), theme.size.row});
            if (ImGui::Selectable("##name", static_cast<int>(i) == chosen, 0,
                                  {row.width(), row.height()})) {
                chosen = static_cast<int>(i);
                edit = Edit::changed;
            }
            const Rect words = {row.lo + glm::vec2(theme.px(4), 0),
                                row.hi - glm::vec2(theme.px(4), 0)};
            paint_text(theme.font.body, words, c.text,
                       elided(theme.font.body, names[i], words.width()));
            ImGui::PopID();
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
    ImGui::PopID();
    return edit;
}

Edit color_field(const Theme& theme, const std::string& id, glm::vec4& linear, float width)
{
    float shown[3] = {to_srgb(linear.x), to_srgb(linear.y), to_srgb(linear.z)};
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(id.c_str());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {theme.px(4), theme.px(4)});
    const bool changed =
        ImGui::ColorEdit3("##color", shown,
                          ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel |
                              ImGuiColorEditFlags_NoOptions);
    ImGui::PopStyleVar();
    ImGui::PopID();
    if (!changed) return command_menu(id);
    for (int i = 0; i < 3; ++i) linear[i] = std::clamp(to_linear(shown[i]), 0.0f, 1.0f);
    return Edit::changed;
}

Edit text_field(const Theme& theme, const std::string& id, std::string& text,
                const std::string& hint, float width, const char* icon)
{
    const Palette& c = theme.color;
    ImGui::PushID(id.c_str());
    const Rect rect = rect_at(cursor(), {width, theme.size.row});
    const float pad = icon ? theme.px(28) : theme.px(8);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, theme.px(4)});
    ImGui::SetNextItemWidth(width);
    const bool changed = ImGui::InputText("##text", &text);
    const bool active = ImGui::IsItemActive();
    ImGui::PopStyleVar();
    ImGui::PopID();
    if (active) paint_rim(rect, c.focus, theme.size.rounding_small, 1.5f * theme.scale);
    if (icon)
        paint_text(theme.font.body, {rect.lo + glm::vec2(theme.px(8), 0), rect.hi}, c.text_2, icon);
    if (text.empty() && !active)
        paint_text(theme.font.body, {rect.lo + glm::vec2(pad, 0), rect.hi}, c.text_3, hint);
    return changed ? Edit::changed : Edit::none;
}

float button_width(const Theme& theme, const std::string& text)
{
    return std::max(theme.px(80), text_width(theme.font.strong, text) + theme.px(32));
}

bool button(const Theme& theme, const std::string& text, ButtonKind kind, glm::vec2 size,
            const char* icon, const std::string& key)
{
    const Palette& c = theme.color;
    if (size.x <= 0) size.x = button_width(theme, text) + (icon ? theme.px(22) : 0);
    if (size.y <= 0) size.y = theme.px(32);
    const PressState p = press_area(text, size);
    const bool off = is_greyed();
    const bool filled = !off && (kind == ButtonKind::primary || kind == ButtonKind::danger);
    if (off && kind != ButtonKind::quiet) kind = ButtonKind::plain;
    const Color rest = kind == ButtonKind::primary  ? c.accent
                       : kind == ButtonKind::danger ? c.bad_fill
                       : kind == ButtonKind::plain  ? c.field
                                                    : 0;
    const Color hot = kind == ButtonKind::primary  ? c.accent_hover
                      : kind == ButtonKind::danger ? c.bad_fill_hover
                      : kind == ButtonKind::plain  ? c.field_hover
                                                   : c.row_hover;
    const bool hovered = p.hovered && !off;
    paint_box(p.rect, p.held ? faded(hot, 0.8f) : hovered ? hot : rest, theme.size.rounding);
    const Color color = off                         ? c.text_off
                        : filled                    ? c.on_accent
                        : kind == ButtonKind::quiet ? c.accent_text
                                                    : c.text;
    const ImFont* font = filled ? theme.font.strong : theme.font.body;
    const Rect inside = {p.rect.lo + glm::vec2(theme.px(12), 0),
                         p.rect.hi - glm::vec2(theme.px(12), 0)};
    if (!icon && key.empty()) {
        paint_text(font, p.rect, color, text, Align::center);
    } else { // a line of a list: icon, words, key
        if (icon) paint_text(font, inside, filled ? color : c.text_2, icon);
        paint_text(font, {inside.lo + glm::vec2(icon ? theme.px(24) : 0, 0), inside.hi}, color,
                   text);
        paint_text(theme.font.small, inside, filled ? color : c.text_2, key, Align::right);
    }
    return p.clicked;
}

bool icon_button(const Theme& theme, const std::string& id, const char* icon, glm::vec2 size,
                 const Tip& tip, IconState state)
{
    const Palette& c = theme.color;
    const PressState p = press_area(id, size);
    const bool tool = size.y >= theme.size.tool_button;
    if (state.on)
        paint_box(p.rect, p.hovered ? c.accent_hover : c.accent, theme.size.rounding);
    else if (p.hovered && state.enabled)
        paint_box(p.rect, c.field_hover, theme.size.rounding_small);
    const Color color = !state.enabled ? c.text_off
                        : state.on     ? c.on_accent
                        : p.hovered    ? c.text
                                       : c.text_2;
    paint_text(tool ? theme.font.tool : theme.font.body, p.rect, color, icon, Align::center);
    tooltip(tip, tool ? Side::right : Side::below);
    return p.clicked && state.enabled;
}

bool lower_area(const char* id, const Rect& area, int buttons)
{
    ImGui::SetCursorScreenPos({area.lo.x, area.lo.y});
    ImGui::SetItemAllowOverlap();
    const bool pressed = ImGui::InvisibleButton(id, {area.width(), area.height()},
                                                buttons | ImGuiButtonFlags_AllowItemOverlap);
    ImGui::SetItemAllowOverlap();
    return pressed;
}

void name_text(const ImFont* font, const Rect& in, Color color, const std::string& name)
{
    const std::string shown = elided(font, name, in.width());
    paint_text(font, in, color, shown);
    if (shown == name) return;
    ImGui::SetCursorScreenPos({in.lo.x, in.lo.y});
    ImGui::PushID(name.c_str());
    ImGui::InvisibleButton("whole", {std::max(1.0f, in.width()), std::max(1.0f, in.height())});
    ImGui::PopID();
    tooltip({name});
}

} // namespace trivar::ui

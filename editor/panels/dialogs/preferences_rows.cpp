// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "editor/panels/dialogs/preferences_pages.h"
#include "ui/widgets.h"

#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// Whether another one than `chosen` was; -1: none is chosen.
bool choose(const ui::Theme& theme, const ui::Row& row, const char* label, int& chosen,
            const std::vector<std::string>& names)
{
    float widest = 0;
    for (const std::string& name : names)
        widest = std::max(widest, ui::text_width(theme.font.body, name));
    const float wanted = (widest + theme.px(24)) * static_cast<float>(names.size());
    return ui::segments(theme, label, chosen, names, std::min(std::round(wanted), row.width)) ==
           ui::Edit::changed;
}

} // namespace

const Preferences& usual_preferences()
{
    static const Preferences usual;
    return usual;
}

void flag_row(const ui::Theme& theme, const char* label, bool& value, bool usual,
              const std::string& effect)
{
    if (ui::label_row(theme, label, value != usual).reset) value = usual;
    ui::check_box(theme, label, value, effect);
}

void choice_row(const ui::Theme& theme, const char* label, std::string& value,
                const std::string& usual, const std::vector<NamedText>& choices)
{
    const ui::Row row = ui::label_row(theme, label, value != usual);
    if (row.reset) value = usual;
    int chosen = -1;
    std::vector<std::string> names;
    for (const NamedText& each : choices) {
        if (each.value == value) chosen = static_cast<int>(names.size());
        names.push_back(each.name);
    }
    if (choose(theme, row, label, chosen, names))
        value = choices[static_cast<std::size_t>(chosen)].value;
}

void choice_row(const ui::Theme& theme, const char* label, double& value, double usual,
                const std::vector<NamedNumber>& choices)
{
    const ui::Row row = ui::label_row(theme, label, value != usual);
    if (row.reset) value = usual;
    int chosen = 0;
    std::vector<std::string> names;
    for (const NamedNumber& each : choices) {
        if (std::abs(each.value - value) <
            std::abs(choices[static_cast<std::size_t>(chosen)].value - value))
            chosen = static_cast<int>(names.size());
        names.push_back(each.name);
    }
    if (choose(theme, row, label, chosen, names))
        value = choices[static_cast<std::size_t>(chosen)].value;
}

void scale_row(Editor& editor, const ui::Theme& theme)
{
    std::vector<NamedNumber> scales;
    for (const double each : interface_scales) scales.push_back({each, percent_text(each)});
    choice_row(theme, "Size", editor.preferences.scale, 1, scales);
}

void foot_note(const ui::Theme& theme, const ui::Rect& r, const std::string& text, ui::Color color)
{
    ui::gap(theme, 12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    float y = at.y;
    for (const std::string& words :
         ui::wrapped(theme.font.small, text, r.width() - 2 * theme.size.padding)) {
        ui::paint_text(theme.font.small,
                       {{at.x + theme.size.padding, y}, {r.hi.x, y + theme.px(18)}},
                       color ? color : theme.color.text_3, words);
        y += theme.px(18);
    }
    ImGui::Dummy({1, y - at.y});
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <functional>
#include <string>
#include <vector>

namespace trivar::ui {

// An Option is a setting of the current tool: its label, its field of a width at scale 1, and the
// sentence of their tooltip.
struct Option {
    std::string words;
    float width = 0;
    std::function<void(float width_px)> field;
    std::string help = {};
};

// Draws the options beside each other from ImGui's cursor on; those that do not fit move into a
// menu behind a button at the end.
void option_bar(const Theme& theme, const std::vector<Option>& options, float room_px);

// Returns the option for a value of an enumeration, by the names of all its values: `draw` is
// choice, a list, or segments, which lie beside each other. The theme and the value outlive it.
template <class Enum>
Option enum_option(decltype(choice)& draw, const Theme& theme, const char* words, float width,
                   const char* id, Enum& value, const std::vector<std::string>& names,
                   const char* help)
{
    return {words, width,
            [&draw, &theme, id, &value, names](float field) {
                int chosen = static_cast<int>(value);
                draw(theme, id, chosen, names, field);
                value = static_cast<Enum>(chosen);
            },
            help};
}
// Returns the option for a switch.
inline Option check_option(const Theme& theme, const char* words, const char* id, bool& value,
                           const char* help)
{
    return {words, 20, [&theme, id, &value](float) { check_box(theme, id, value, ""); }, help};
}

} // namespace trivar::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

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

} // namespace trivar::ui

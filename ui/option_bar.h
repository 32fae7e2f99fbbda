// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <functional>
#include <string>
#include <vector>

namespace trivar::ui {

// A setting of the tool at hand: its label, and its field of a width at scale 1.
struct Option {
    std::string words;
    float width = 0;
    std::function<void(float width_px)> field;
};

// Beside each other from ImGui's cursor on; those that do not fit move, whole, into a menu behind
// a button at the end.
void option_bar(const Theme& theme, const std::vector<Option>& options, float room_px);

} // namespace trivar::ui

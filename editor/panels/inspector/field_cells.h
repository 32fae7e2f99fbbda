// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <cmath>
#include <glm/glm.hpp>

namespace trivar {

// FieldCells places the fields of one row: side by side, or below each other if they would be too
// narrow to show a number.
struct FieldCells {
    float width = 0; // of each, pixels
    glm::vec2 step{0};

    // Lays out `count` fields in a row of that width, in pixels.
    FieldCells(const ui::Theme& theme, float row_width, int count)
    {
        constexpr float least = 53; // at scale 1: "-123.4" beside the letter of its axis
        const float gap = theme.px(4), n = static_cast<float>(count);
        width = std::floor((row_width - (n - 1) * gap) / n);
        step = {width + gap, 0};
        if (count == 1 || width >= theme.px(least)) return;
        width = row_width;
        step = {0, theme.size.row + gap};
    }
    glm::vec2 offset(int i) const { return static_cast<float>(i) * step; }
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/height_map.h"
#include "editor/panels/inspector/key_gutter.h"
#include "ui/widgets.h"

namespace trivar {

struct HeightMapRows {
    RowWords words;
    double size_world = 0; // metres, the size that the factors multiply; 0: not known yet
    const KeyGutter* keys = nullptr;
};
// Draws a list of shapes to begin with and, where it is unfolded, its surface, the size of the grid
// and the number of the chosen point.
ui::Edit draw_height_map(const ui::Theme& theme, const HeightMapRows& rows, HeightGrid& grid,
                         int& chosen);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/shown_volume.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/session/level_scouts.h"

#include <string>

namespace trivar {

// LevelRows is the input for drawing the rows of levels of volume data.
struct LevelRows {
    const ShownVolume* shown = nullptr;      // null: not evaluated yet, or it cannot be read
    const ScoutedVolume* scouted = nullptr;  // null: not known yet
    std::string unit = {};                   // of the values
    std::string parameter(int number) const; // "shape.levels.0"
};

// The histogram with its levels as lines that are dragged, and below it how much line each level
// would give.
void draw_level_histogram(ValueRows& rows, const LevelRows& of, VoxelShape& shape, int& chosen);
// Draws a row for each level: colour, name, value, and the parts of it that are shown. A click on
// the name chooses it.
void draw_level_list(ValueRows& rows, const LevelRows& of, VoxelShape& shape, int& chosen);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/inspector/volume_level_rows.h"

namespace trivar {

// The point of a transfer function that a hand chose; it belongs to one object.
struct ChosenTransferPoint {
    Id object = 0;
    int number = -1; // -1: none
};

// The transfer function over the histogram, and the numbers and the colour of the chosen point.
void draw_transfer(ValueRows& rows, const LevelRows& of, VolumeCasting& casting, int& chosen);

} // namespace trivar

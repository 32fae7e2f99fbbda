// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <functional>

namespace trivar::ui {

// How a surface over [0, 1]^2 is shown and what its control values may be.
struct HeightStyle {
    std::function<double(double u, double v)> at; // the surface of the values as they are
    std::vector<double> along, across;            // where those stand
    double lo = 0, hi = 1;                        // what they may be
    double scale = 1;      // what is written is so many times the surface, ...
    std::string unit = {}; // ... in this unit
    Color color = 0;
};

// A surface by a grid of control values, rows along u, in each those across: seen from v = 0, and
// from above as cells, v = 1 on top. A dot of the one and a cell of the other is dragged up and
// down (Shift ten times finer, Ctrl in round steps); a double click has the next number field take
// what is typed. `chosen` is the value in the hand, or was last, row by row; -1: none. Esc restores
// during a drag.
Edit height_field(const Theme& theme, const std::string& id,
                  std::vector<std::vector<double>>& values, int& chosen, const HeightStyle& style,
                  float width);

} // namespace trivar::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <functional>

namespace trivar::ui {

// A HeightStyle says how a surface over [0, 1]^2 is shown and which control values are allowed.
struct HeightStyle {
    std::function<double(double u, double v)> at; // the surface of the present values
    std::vector<double> along, across;            // the places of the values
    double lo = 0, hi = 1;                        // the range of the values
    double scale = 1;      // the written numbers are the surface's values times this, ...
    std::string unit = {}; // ... in this unit
    Color color = 0;
};

// A surface by a grid of control values, rows along u, each with the values across. It is shown
// twice: from v = 0, with a dot per value, and from above, with a cell per value and v = 1 on top.
// A dot or a cell is dragged up and down (Shift ten times finer, Ctrl in round steps); after a
// double click the next number field takes what is typed. `chosen` is the value in the hand, or the
// last one that was, row by row; -1: none. Esc restores during a drag.
Edit height_field(const Theme& theme, const std::string& id,
                  std::vector<std::vector<double>>& values, int& chosen, const HeightStyle& style,
                  float width);

} // namespace trivar::ui

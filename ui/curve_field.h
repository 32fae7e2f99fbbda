// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <array>
#include <functional>

namespace trivar::ui {

// How a curve over [0, 1] is shown and what its control points may be.
struct CurveStyle {
    std::function<double(double)> at; // the curve of the points as they are
    double lo = 0, hi = 1;            // of the values
    double scale = 1;                 // what is written beside a value is so many times it, ...
    std::string unit = {};            // ... in this unit
    Color color = 0;
    std::size_t most_points = 64;
    bool ascends = false; // the values, by this much from point to point, between fixed ends:
    double least_step = 0;
    std::array<std::string, 2> ends{"0", "1"}; // what stands below them
};

// A curve that is edited by its control points (place, value), which ascend from 0 to 1: drag one
// (Shift ten times finer, Ctrl in round steps), Ctrl click adds one or takes the one under the
// mouse away, as Del does with the chosen one while the mouse is over the curve; a double click has
// the next number field take what is typed. The first and the last keep their places. `chosen` is
// the point in the hand, or was last; -1: none. Esc restores during a drag.
Edit curve_field(const Theme& theme, const std::string& id, std::vector<glm::dvec2>& points,
                 int& chosen, const CurveStyle& style, float width);

} // namespace trivar::ui

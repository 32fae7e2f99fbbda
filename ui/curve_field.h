// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <array>
#include <functional>

namespace trivar::ui {

// A CurveStyle says how a curve over [0, 1] is shown and which control points are allowed.
struct CurveStyle {
    std::function<double(double)> at; // the curve of the present points
    double lo = 0, hi = 1;            // of the values
    double scale = 1;                 // the numbers beside values are the values times this, ...
    std::string unit = {};            // ... in this unit
    Color color = 0;
    std::size_t most_points = 64;
    // the values ascend by at least `least_step` from point to point, between fixed ends
    bool ascends = false;
    double least_step = 0;
    std::array<std::string, 2> ends{"0", "1"}; // the words below both ends
};

// A curve that is edited by its control points (place, value), which ascend from 0 to 1. A point is
// dragged (Shift ten times finer, Ctrl in round steps). Ctrl click adds a point or removes the one
// under the mouse; Del removes the chosen one while the mouse is over the curve. After a double
// click the next number field takes what is typed. The first and the last point keep their places.
// `chosen` is the point in the hand, or the last one that was; -1: none. Esc restores during a
// drag.
Edit curve_field(const Theme& theme, const std::string& id, std::vector<glm::dvec2>& points,
                 int& chosen, const CurveStyle& style, float width);

} // namespace trivar::ui

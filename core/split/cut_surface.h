// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"
#include "core/split/obstacle_columns.h"

namespace trivar {

// A CutSurface is u = phi(v, w): a bicubic spline through the middle of an obstacle, so that a
// leaning or bent obstacle asks for no wider an opening than an upright one. Beyond its domain it
// goes on as it is at the border.
using CutSurface = Surface<double>;

// A rectangle of (v, w), metres.
struct SplitRectangle {
    glm::dvec2 lo{0}, hi{0};
};

// Fits a surface to the middles of an obstacle's columns, by least squares with a small penalty on
// second differences. By the penalty it extends smoothly beyond the obstacle's shadow, over the
// whole rectangle `over` and a little further. About 10 ms.
CutSurface middle_surface(const ObstacleColumns& columns, const SplitRectangle& over);

} // namespace trivar

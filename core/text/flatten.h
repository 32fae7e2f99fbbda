// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

#include <span>

namespace trivar {

// Appends the points of a Bezier curve of degree 2 or 3 that follow its first one, which already
// ends the loop. There are enough points that the chords are within `tolerance` of the curve and
// none turns by more than 20 degrees against the one before. Units of the grid. A chord of n even
// steps in the parameter is within |second difference| degree (degree - 1) / (8 n^2).
void append_curve(Loop& loop, std::span<const glm::dvec2> control, double tolerance);

} // namespace trivar

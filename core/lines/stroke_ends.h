// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"

namespace trivar {

// Joins strokes whose ends face each other within a number of pixels, at directions that differ by
// at most 60 degrees, the nearest pairs first; hidden ones with hidden ones. What is joined does
// not taper there. O(n log n).
std::vector<Stroke> joined(std::vector<Stroke> strokes, float reach);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"

#include <span>

namespace trivar {

// Joins strokes whose ends face each other within a number of pixels, at directions that differ by
// at most 60 degrees, the nearest pairs first; hidden ones with hidden ones. What is joined does
// not taper there. O(n log n).
std::vector<Stroke> joined(std::vector<Stroke> strokes, float reach);

// Ends of strokes that are as near to a point of another stroke, in pixels, do not taper any more:
// they are corners, or go behind what that outlines. Hidden strokes hold no seen end. Linear.
void hold_ends(std::span<Stroke* const> strokes, float reach);

} // namespace trivar

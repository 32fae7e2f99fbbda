// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// Returns how much of each stroke stays when the level changes a little: the share of its points
// that have one of the nearby drawings' points within the reach, the mean over these drawings.
// O(#points).
std::vector<float> persistence(std::span<const Stroke> strokes,
                               std::span<const std::vector<Stroke>> nearby, float reach_px = 3);

// Keeps the strokes that tell most, up to a share (0 .. 1) of the length of all, in their order; of
// seen ones and of hidden ones each. A stroke counts by its length, the more the steeper the field
// is along it, the more distinct it is, and by its weight (see persistence(); none: 1). Strokes
// that were kept in the view before, by their ids, count a quarter more, so that they do not come
// and go while one turns. O(n log n).
std::vector<Stroke> within_budget(std::vector<Stroke> strokes, float share,
                                  std::span<const float> weights = {},
                                  std::span<const std::uint64_t> kept_before = {});

} // namespace trivar

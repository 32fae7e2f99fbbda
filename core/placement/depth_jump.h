// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace trivar {

// A DepthJump is a place of a stroke where its rays change from one surface to another behind an
// edge, or before one.
struct DepthJump {
    double at = 0;    // share of the stroke's way in the picture
    double depth = 0; // metres along the sight; positive: the other surface is behind
};
const DepthJump& deepest(const std::vector<DepthJump>& jumps); // of one at least

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/gait.h"

namespace trivar {

// How the nodes stand with every foot where its gait has it: in its stance what touches the ground
// goes with it, so that a model that goes on at the gait's stride does not slide, and in the air
// nothing touches it. Where the clip has the foot elsewhere it is moved, and its leg is sheared
// after it: by nothing at the hip, as much as the foot at its own node, in proportion to the length
// of the leg between, so that joints stay together. A gait without a stride changes nothing.
Stance planted(const Model& model, const Clip& clip, const Gait& gait, double time_s);

// How far the sole goes with its leg's end, as a share: a joint above the foot may have a part in
// its skin. planted() moves the leg by as much more, where the share is larger than the least.
double share_of_sole(const Model& model, const Foot& foot, const Stance& stance);
inline constexpr double least_share_of_sole = 0.5;

// The largest distance by which that moves a sole, as a share of the stride.
double largest_correction(const Gait& gait);

} // namespace trivar

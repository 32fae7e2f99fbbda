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

// The largest distance by which that moves a sole, as a share of the stride.
double largest_correction(const Gait& gait);

} // namespace trivar

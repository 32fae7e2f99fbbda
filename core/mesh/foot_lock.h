// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/gait.h"

namespace trivar {

// How the nodes stand with every foot in its stance where the ground carries it, so that a model
// that goes on at the gait's stride does not slide. Where the clip has the foot elsewhere it is
// moved along the ground, and its leg is sheared after it: by nothing at the hip, as much as the
// foot at its own node, in proportion to the length of the leg between, so that joints stay
// together. What is added fades from step to step while the foot is in the air. A gait without a
// stride changes nothing.
Stance planted(const Model& model, const Clip& clip, const Gait& gait, double time_s);

// The largest distance by which that moves a sole, as a share of the stride.
double largest_correction(const Model& model, const Clip& clip, const Gait& gait);

} // namespace trivar

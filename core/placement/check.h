// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// Throws Rejected for parameters out of their ranges, with the range in the sentence.
void check(const PlacementParameters& parameters);

// Throws Rejected for a perspective camera inside a closed object.
void check_enclosed(const Camera& camera, const RayScene& scene);

} // namespace trivar

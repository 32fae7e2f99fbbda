// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

// Distances to anatomy, and a density: what the bone models and the crystal are sampled from.
namespace make {

float hand_bone(vec3 p);
float jaw_bone(vec3 p);
float jaw_teeth(vec3 p);
float crystal_density(vec3 p); // silicon, two periods in [0, 1]^3

} // namespace make

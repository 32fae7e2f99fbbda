// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// The strip while the stroke is still being drawn: the middle line and the two rims, in the world.
// Empty as long as the stroke is too short or meets nothing. `width` in metres; 0: a fifth of the
// length. About 200 rays; no springs, no lift.
std::vector<std::vector<glm::dvec3>> preview_strip(const Sketch& sketch, double width,
                                                   const RayScene& scene);

} // namespace trivar

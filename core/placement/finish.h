// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/layout.h"

namespace trivar {

// From nodes, displaced by s along their springs, to the placement: contact surface, lift, volume,
// embedding, report. What place() does with the nodes at rest and an animation with moving ones.
Placement finished(const StripLayout& layout, const std::vector<double>& s, const Camera& camera,
                   const PlacementParameters& parameters, const ModelFrame& frame,
                   const RayScene& scene, Timings& timings);

// The middle line of a contact surface and its two rims, as chords.
std::vector<std::vector<glm::dvec3>> outline(const Surface<glm::dvec3>& contact);

} // namespace trivar

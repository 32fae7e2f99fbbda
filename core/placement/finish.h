// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/layout.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// Finishes a placement from its nodes: contact surface, lift, volume, embedding, report. place()
// calls it with the nodes at rest, an animation with moving ones.
//   s      #nodes: the displacements along the springs
//   frame  how the model is turned
Placement finished(const StripLayout& layout, const std::vector<double>& s, const Camera& camera,
                   const PlacementParameters& parameters, const ModelFrame& frame,
                   const RayScene& scene, Timings& timings);

// The middle line of a contact surface and both of its rims, as chords.
std::vector<std::vector<glm::dvec3>> outline(const Surface<glm::dvec3>& contact);

} // namespace trivar

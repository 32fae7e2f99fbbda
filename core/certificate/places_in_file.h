// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/mesh/pose.h"

namespace trivar {

// The first function returns the vertices of a part, world, metres, as the file shows them at a
// time by the rules of glTF. The second one returns them as the scene shows them outside of
// volumes.
std::vector<glm::dvec3> places_in_file(const Model& model, int node, const Stance& stance,
                                       const Channel* weights, double time_s);
std::vector<glm::dvec3> places_in_scene(const Part& part);

// The channel of the model's first clip that drives the target weights of a node, or null.
const Channel* weights_of_node(const Model& model, int node);

} // namespace trivar

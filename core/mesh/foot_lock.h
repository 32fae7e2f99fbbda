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

// p moves by (a + b . p) d.
struct Shear {
    double a = 1;
    glm::dvec3 b{0};
    glm::dmat4 matrix(const glm::dvec3& d) const;
};
// Of the nodes of a leg: each as much as its own joint at that joint, as the next at the next.
std::vector<Shear> shears(const Foot& foot, const Stance& stance);
// From each of its joints to the next; what is hardly any by that of the leg is none, and so is a
// leg's by how far it is from the origin.
std::vector<double> bone_lengths(const Foot& foot, const Stance& stance);
inline constexpr double no_length = 1e-9;
// Which of a leg's nodes moves a node: an index into the leg, -1: none; by node.
std::vector<int> bones_of_nodes(const Model& model, const Foot& foot);

// How far the sole goes with its leg's end, as a share: a joint above the foot may have a part in
// its skin. planted() moves the leg by as much more, where the share is larger than the least.
double share_of_sole(const Model& model, const Foot& foot, const Stance& stance);
inline constexpr double least_share_of_sole = 0.5;

// The largest distance by which that moves a sole, as a share of the stride.
double largest_correction(const Gait& gait);

} // namespace trivar

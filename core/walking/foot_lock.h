// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walking/gait.h"

namespace trivar {

// The pose of the nodes with every foot where its gait has it. In its stance the sole moves with
// the ground, so that a model that moves on at the gait's stride does not slide; in the air no foot
// touches the ground. Where the clip has a foot elsewhere, the foot is moved and its leg is sheared
// after it: by 0 at the hip, by the foot's whole way at the foot's own node, and between in
// proportion to the length of the leg, so that joints stay together. A gait without a stride
// changes nothing.
Stance planted(const Model& model, const Clip& clip, const Gait& gait, double time_s);

// A Shear moves p by (a + b . p) d.
struct Shear {
    double a = 1;
    glm::dvec3 b{0};
    glm::dmat4 matrix(const glm::dvec3& d) const;
};
// The shears of a leg's nodes: at each joint, a node moves by as much as its joint, and at the next
// joint by as much as that one.
std::vector<Shear> shears(const Foot& foot, const Stance& stance);
// The distance from each joint of a leg to the next. A bone shorter than no_length times its leg
// counts as 0, and so does a leg shorter than no_length times its distance from the origin.
std::vector<double> bone_lengths(const Foot& foot, const Stance& stance);
inline constexpr double no_length = 1e-9;
// Returns for each node of the model which of the leg's nodes moves it: an index into the leg, or
// -1 for none.
std::vector<int> bones_of_nodes(const Model& model, const Foot& foot);

// The share of the movement of its leg's end that the sole makes: a joint above the foot may move a
// part of its skin. planted() moves the leg by more accordingly, where the share is above
// least_share_of_sole.
double share_of_sole(const Model& model, const Foot& foot, const Stance& stance);
inline constexpr double least_share_of_sole = 0.5;

// The largest distance by which planted() moves a sole, as a share of the stride.
double largest_correction(const Gait& gait);

} // namespace trivar

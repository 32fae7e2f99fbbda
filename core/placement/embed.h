// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// Which side of the model lies on the scene: its box as it looks along +x with +z up.
enum class Underside { bottom, right, top, left, front, back };
// That, and the quarter turns about the vertical that follow: each of the 24 ways a box can lie is
// one of these, and one choice of the parameters along, roll_deg and reverse.
struct Lying {
    Underside on = Underside::bottom;
    int quarters = 0; // 0..3, toward the left
    bool operator==(const Lying&) const = default;
};
Lying lying_of(const PlacementParameters& parameters);
PlacementParameters with_lying(PlacementParameters parameters, const Lying& lying);

// Whether it looks toward the start of its stroke. The front of a model is at its +x; where its y
// axis runs along the stroke at its -y, as of glTF's assets, whose front is +Z with Y up (glTF 2.0,
// 3.4). Which models have it elsewhere no file says.
bool looks_back(const PlacementParameters& parameters);

// As a model is laid that nobody turned yet: where its box is longer along y by a fifth, y runs
// along the stroke, its front ahead.
PlacementParameters lengthwise(PlacementParameters parameters, const Box& model);

// How a model lies along a stroke: turned so, and what its box measures then. An edge without
// length counts as flat.
struct ModelFrame {
    glm::dmat3 turn{1};
    Box box; // of the turned model
    glm::bvec3 flat{false};
};
ModelFrame model_frame(const PlacementParameters& parameters, const Box& model);

// Width and height of the strip for a stroke of the given length, metres: those asked for, or in
// proportion to the model, so that it is not distorted. A flat side gets a twentieth of the length.
double strip_width(const ModelFrame& frame, const PlacementParameters& parameters, double length);
double volume_height(const ModelFrame& frame, const PlacementParameters& parameters, double length);

// Object space to the volume's parameters: +x along u from `start`, `fill` long; y across; z up.
glm::dmat4 model_to_uvw(const ModelFrame& frame, const PlacementParameters& parameters);

} // namespace trivar

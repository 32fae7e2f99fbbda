// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// The side of the model that lies on the scene, named as the model's box looks along +x with +z up.
enum class Underside { bottom, right, top, left, front, back };
// Lying is that side and the quarter turns about the vertical that follow. Each of the 24 ways in
// which a box can lie is one Lying, and one choice of the parameters along, roll_deg and reverse.
struct Lying {
    Underside on = Underside::bottom;
    int quarters = 0; // 0..3, toward the left
    bool operator==(const Lying&) const = default;
};
Lying lying_of(const PlacementParameters& parameters);
PlacementParameters with_lying(PlacementParameters parameters, const Lying& lying);

// Whether the model looks toward the start of its stroke. The front of a model is taken to be at
// its +x; where its y axis runs along the stroke, at its -y, as in glTF's assets, whose front is +Z
// with Y up (glTF 2.0, 3.4). No file says which models have their front elsewhere.
bool looks_back(const PlacementParameters& parameters);

// The parameters for a model that nobody has turned yet: where its box is longer along y by a
// fifth, y runs along the stroke, with the front ahead.
PlacementParameters lengthwise(PlacementParameters parameters, const Box& model);

// A ModelFrame says how a model is turned to lie along a stroke, and the box of the model so
// turned. An edge without length counts as flat.
struct ModelFrame {
    glm::dmat3 turn{1};
    Box box; // of the turned model
    glm::bvec3 flat{false};
};
ModelFrame model_frame(const PlacementParameters& parameters, const Box& model);

// Width and height of the strip for a stroke of the given length, in metres: the sizes in the
// parameters, or else sizes in proportion to the model, so that it is not distorted. A flat side
// gets a twentieth of the length.
double strip_width(const ModelFrame& frame, const PlacementParameters& parameters, double length);
double volume_height(const ModelFrame& frame, const PlacementParameters& parameters, double length);

// Maps object space to the volume's parameters:
//
//      u = 0      start                 start + fill      1     along the stroke
//        |----------[ -x   model   +x ]----------------|
//
// y runs across, z up.
glm::dmat4 model_to_uvw(const ModelFrame& frame, const PlacementParameters& parameters);

} // namespace trivar

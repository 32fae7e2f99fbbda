// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// How a model lies along a stroke: turned by the roll and the reversal, and what its box measures
// then. An edge without length counts as flat.
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

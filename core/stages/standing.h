// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/curve_part.h"
#include "core/stages/shape.h"

#include <vector>

namespace trivar {

// A StandingMesh is a mesh of a shape before it is laid, with the matrix from it to the model's
// box.
struct StandingMesh {
    Part part;
    glm::dmat4 to_box;
};
// The meshes of a shape with the object's own rotation and scale. Meshes that these mirror are
// turned inside out first, so that no mirror stands between them and a volume.
std::vector<StandingMesh> standing(const Shape& shape, const glm::dmat3& turned);

// The meshes of a shape as parts in its model's space.
std::vector<Part> parts_in_model(const Shape& shape);

// StandingCurves is the same for curves. Curves may be mirrored: lines have no front.
struct StandingCurves {
    CurvePart part;
    glm::dmat4 to_box;
};
std::vector<StandingCurves> standing_curves(const Shape& shape, const glm::dmat3& turned);

// The embedding of such a mesh in the volume in which the box is embedded.
Embedding embedded(const Embedding& box, const glm::dmat4& to_box);

} // namespace trivar

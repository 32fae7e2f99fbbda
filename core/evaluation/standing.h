// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/curve_part.h"
#include "core/evaluation/shape.h"

#include <vector>

namespace trivar {

// A mesh of a shape before it is laid, and the matrix from it to the box of the model.
struct StandingMesh {
    Part part;
    glm::dmat4 to_box;
};
// The meshes of a shape with the object's own turn and size. Those that these mirror are turned
// round first, so that no mirror stands between them and a volume.
std::vector<StandingMesh> standing(const Shape& shape, const glm::dmat3& turned);

// The same of its curves, which may be mirrored: lines have no front.
struct StandingCurves {
    CurvePart part;
    glm::dmat4 to_box;
};
std::vector<StandingCurves> standing_curves(const Shape& shape, const glm::dmat3& turned);

// How such a mesh lies in the volume that the box lies in.
Embedding embedded(const Embedding& box, const glm::dmat4& to_box);

} // namespace trivar

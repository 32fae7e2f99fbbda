// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace trivar {

// The matrix whose columns are the cross products of those of m: where m maps tangent vectors, it
// maps normals. det(m) times the inverse transpose, but defined for any m.
glm::dmat3 cofactor(const glm::dmat3& m);

// Replaces the normals that are (0, 0, 0) but are not in the mesh by the area-weighted ones of the
// faces around them, with vertices at `positions`; where these have no area either, by the mesh's
// own. #V in and out.
std::vector<glm::vec3> fill_missing_normals(const Mesh& mesh,
                                            const std::vector<glm::vec3>& positions,
                                            std::vector<glm::vec3> normals);

// `tangent` made orthogonal to the unit vector `normal`, unit, w kept. Where it has no part
// orthogonal to the normal, some vector that has.
glm::vec4 orthogonal_tangent(const glm::vec4& tangent, const glm::vec3& normal);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace trivar {

// The matrix whose columns are the cross products of the columns of m: where m maps tangent
// vectors, it maps normals. It equals det(m) times the inverse transpose, but is defined for any m.
glm::dmat3 cofactor(const glm::dmat3& m);

// Replaces normals that became (0, 0, 0), and are not so in the mesh, by the area-weighted normals
// of the faces around them, with vertices at `positions`; where these faces have no area either, by
// the mesh's own normals. #V in and out.
std::vector<glm::vec3> fill_missing_normals(const Mesh& mesh,
                                            const std::vector<glm::vec3>& positions,
                                            std::vector<glm::vec3> normals);

// `tangent` made unit and orthogonal to the unit vector `normal`, with w kept. Where the tangent is
// parallel to the normal, some orthogonal vector.
glm::vec4 orthogonal_tangent(const glm::vec4& tangent, const glm::vec3& normal);

} // namespace trivar

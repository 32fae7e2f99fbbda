// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/level_side.h"
#include "core/level/level_mesh.h"
#include "core/mesh/mesh.h"

namespace trivar {

// Makes the closed surface of a body: the level, turned so that its normals point out of the body,
// and the parts of the grid's faces that are in the body.
//   samples   those from which the level was made, x fastest
//   size      number of samples along each axis
//   to_space  maps voxels to the mesh's space; affine and not singular
// Normals of the level have the gradient's direction; vertices of the grid's faces have the face's
// normal and stand at the same point. Vertices at one place count as one point. O(#triangles +
// #samples in faces).
template <class Sample>
Mesh level_surface(const LevelMesh& level, std::span<const Sample> samples, const glm::ivec3& size,
                   LevelSide side, const glm::dmat4& to_space);

} // namespace trivar

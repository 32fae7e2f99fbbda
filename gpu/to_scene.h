// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::gpu {

// A ToScene says how a mesh stands in scene space; see gpu/scene.h.
struct ToScene {
    glm::mat4 points{1};
    glm::mat3 normals{1};
    bool mirrors = false; // turns faces round
};

// Computes it from the mesh's matrix in the world, the origin of its positions, and the world point
// that is the scene's origin.
inline ToScene to_scene(glm::dmat4 to_world, const glm::dvec3& mesh_origin,
                        const glm::dvec3& scene_origin_world)
{
    to_world = glm::translate(to_world, mesh_origin);
    to_world[3] -= glm::dvec4(scene_origin_world, 0);
    const glm::dmat3 linear(to_world);
    const double volume = glm::determinant(linear);
    // Cofactors turn normals right even where the matrix is flat; a mirror flips their sign.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double size = std::cbrt(std::abs(volume)) + 1e-30;
    return {to_world, cofactors * ((volume < 0 ? -1 : 1) / (size * size)), volume < 0};
}

} // namespace trivar::gpu

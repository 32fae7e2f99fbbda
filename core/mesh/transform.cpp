// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/transform.h"

#include "core/base/parallel.h"
#include "core/base/unit.h"

#include <algorithm>

namespace trivar {

void transform_again(Mesh& out, const Mesh& mesh, const glm::dmat4& matrix)
{
    const glm::dmat3 linear(matrix);
    const double determinant = glm::determinant(linear);
    // Cofactors are used instead of the inverse because they exist for a singular matrix too.
    const glm::dmat3 cofactors =
        glm::dmat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                   glm::cross(linear[0], linear[1])) *
        (determinant < 0 ? -1.0 : 1.0);
    constexpr std::size_t per_block = 1 << 13;
    parallel_blocks(mesh.vertex_count(), per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            out.positions[v] = glm::vec3(matrix * glm::dvec4(mesh.positions[v], 1));
        for (std::size_t v = begin; v < end && !mesh.normals.empty(); ++v)
            out.normals[v] = glm::vec3(
                unit_or(cofactors * glm::dvec3(mesh.normals[v]), glm::dvec3(mesh.normals[v])));
        for (std::size_t v = begin; v < end && !mesh.tangents.empty(); ++v) {
            const glm::vec4& t = mesh.tangents[v];
            const glm::dvec3 before(t);
            out.tangents[v] = glm::vec4(glm::vec3(unit_or(linear * before, before)),
                                        determinant < 0 ? -t.w : t.w);
        }
    });
}

Mesh transformed(const Mesh& mesh, const glm::dmat4& matrix)
{
    Mesh result = mesh;
    transform_again(result, mesh, matrix);
    if (glm::determinant(glm::dmat3(matrix)) < 0)
        for (std::size_t f = 0; f < result.face_count(); ++f)
            std::reverse(result.corners.begin() + result.face_begin[f] + 1,
                         result.corners.begin() + result.face_begin[f + 1]);
    return result;
}

} // namespace trivar

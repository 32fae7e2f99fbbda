// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/normals.h"

#include <cmath>

namespace trivar {
namespace {

// Returns twice the area vector of a polygon, by Newell's formula.
glm::dvec3 area_vector(const Mesh& mesh, std::size_t face, const std::vector<glm::vec3>& positions)
{
    glm::dvec3 sum(0);
    const std::uint32_t begin = mesh.face_begin[face], end = mesh.face_begin[face + 1];
    const glm::dvec3 origin(positions[mesh.corners[begin]]);
    for (std::uint32_t c = begin + 1; c + 1 < end; ++c)
        sum += glm::cross(glm::dvec3(positions[mesh.corners[c]]) - origin,
                          glm::dvec3(positions[mesh.corners[c + 1]]) - origin);
    return sum;
}

} // namespace

glm::dmat3 cofactor(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

std::vector<glm::vec3> fill_missing_normals(const Mesh& mesh,
                                            const std::vector<glm::vec3>& positions,
                                            std::vector<glm::vec3> normals)
{
    std::vector<std::uint32_t> slot(normals.size(), 0); // 1-based index into `sums`; 0: none
    std::vector<glm::dvec3> sums(1);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        if (normals[v] != glm::vec3(0) || mesh.normals[v] == glm::vec3(0)) continue;
        slot[v] = static_cast<std::uint32_t>(sums.size());
        sums.emplace_back(0);
    }
    if (sums.size() == 1) return normals;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const glm::dvec3 area = area_vector(mesh, f, positions);
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            sums[slot[mesh.corners[c]]] += area;
    }
    for (std::size_t v = 0; v < normals.size(); ++v) {
        if (slot[v] == 0) continue;
        const glm::dvec3& sum = sums[slot[v]];
        const double length = glm::length(sum);
        const bool usable = length > 0 && std::isfinite(length);
        normals[v] = usable ? glm::vec3(sum / length) : mesh.normals[v];
    }
    return normals;
}

glm::vec4 orthogonal_tangent(const glm::vec4& tangent, const glm::vec3& normal)
{
    const glm::dvec3 n(normal), t(tangent);
    glm::dvec3 across = t - n * glm::dot(n, t);
    if (!(glm::length(across) > 1e-6 * glm::length(t)) || !std::isfinite(glm::length(across))) {
        const glm::dvec3 axis = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        across = axis - n * glm::dot(n, axis);
    }
    return {glm::vec3(glm::normalize(across)), tangent.w};
}

} // namespace trivar

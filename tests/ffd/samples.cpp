// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ffd/samples.h"

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace trivar::testing {

Mesh scattered_points(std::size_t count, float lo, float hi, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> in(lo, hi), about(-1, 1);
    const auto direction = [&] {
        return glm::normalize(glm::vec3(about(random), about(random), about(random)));
    };
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.emplace_back(in(random), in(random), in(random));
        const glm::vec3 n = direction();
        mesh.normals.push_back(n);
        mesh.tangents.emplace_back(glm::normalize(glm::cross(n, direction())),
                                   i % 2 ? 1.0f : -1.0f);
    }
    return mesh;
}

glm::dmat4 some_affine_map()
{
    const glm::dmat4 shift = glm::translate(glm::dmat4(1), glm::dvec3(3, -2, 5));
    const glm::dmat4 turn = glm::rotate(shift, 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    return glm::scale(turn, glm::dvec3(2, 0.5, 1.5));
}

Mesh deform_in_double(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice)
{
    Mesh out = mesh;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const DeformedPoint at = deform(glm::dvec3(mesh.positions[v]), embedding, lattice);
        out.positions[v] = glm::vec3(at.position_world);
        if (mesh.normals.empty()) continue;
        const glm::dmat3& j = at.jacobian;
        const glm::dmat3 cofactor(glm::cross(j[1], j[2]), glm::cross(j[2], j[0]),
                                  glm::cross(j[0], j[1]));
        const glm::dvec3 n = glm::normalize(cofactor * glm::dvec3(mesh.normals[v]));
        out.normals[v] = glm::vec3(n);
        if (mesh.tangents.empty()) continue;
        const glm::dvec3 t = j * glm::dvec3(mesh.tangents[v]);
        out.tangents[v] =
            glm::vec4(glm::vec3(glm::normalize(t - n * glm::dot(n, t))), mesh.tangents[v].w);
    }
    return out;
}

double largest_distance(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    double most = a.size() == b.size() ? 0 : 1e300;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        const double distance = glm::length(glm::dvec3(a[i]) - glm::dvec3(b[i]));
        most = distance <= most ? most : distance; // so that NaN counts
    }
    return most;
}

double angle_deg(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

} // namespace trivar::testing

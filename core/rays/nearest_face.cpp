// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rays/nearest_face.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trivar {
namespace {

std::optional<double> meeting(const glm::dvec3& origin, const glm::dvec3& along,
                              const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(along, ac);
    const double det = glm::dot(ab, p);
    if (std::abs(det) < 1e-300) return std::nullopt;
    const glm::dvec3 s = origin - a, q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / det, v = glm::dot(along, q) / det;
    const double t = glm::dot(ac, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || t <= 0) return std::nullopt;
    return t;
}

} // namespace

double nearest_face(const Mesh& mesh, const glm::dmat4& to_world, const glm::dvec3& origin,
                    const glm::dvec3& along, double nearest)
{
    const auto corner = [&](std::uint32_t c) {
        return glm::dvec3(to_world * glm::dvec4(mesh.positions[mesh.corners[c]], 1));
    };
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        const glm::dvec3 a = corner(begin);
        for (std::uint32_t c = begin + 1; c + 1 < end; ++c)
            if (const auto t = meeting(origin, along, a, corner(c), corner(c + 1)))
                nearest = std::min(nearest, *t);
    }
    return nearest;
}

} // namespace trivar

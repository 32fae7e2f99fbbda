// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/morphed.h"

#include <algorithm>

namespace trivar {
namespace {

// Goes from one unit vector toward another; the first where they cancel out.
glm::vec3 between(const glm::vec3& from, const glm::vec3& to, float t)
{
    const glm::vec3 sum = from + t * (to - from);
    const float length = glm::length(sum);
    return length > 1e-6f ? sum / length : from;
}

} // namespace

bool can_become(const Mesh& from, const Mesh& to)
{
    return from.vertex_count() == to.vertex_count() && from.corners.size() == to.corners.size();
}

Mesh morphed(const Mesh& from, const Mesh& to, double t)
{
    Mesh mesh = from;
    const auto share = static_cast<float>(t);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.positions[v] += share * (to.positions[v] - from.positions[v]);
    if (to.normals.size() == mesh.normals.size())
        for (std::size_t v = 0; v < mesh.normals.size(); ++v)
            mesh.normals[v] = between(from.normals[v], to.normals[v], share);
    if (to.tangents.size() == mesh.tangents.size())
        for (std::size_t v = 0; v < mesh.tangents.size(); ++v)
            mesh.tangents[v] = {
                between(glm::vec3(from.tangents[v]), glm::vec3(to.tangents[v]), share),
                from.tangents[v].w};
    if (to.colors.size() == mesh.colors.size())
        for (std::size_t v = 0; v < mesh.colors.size(); ++v)
            mesh.colors[v] =
                glm::clamp(from.colors[v] + share * (to.colors[v] - from.colors[v]), 0.0f, 1.0f);
    return mesh;
}

} // namespace trivar

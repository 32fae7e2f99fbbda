// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/alike.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trivar {
namespace {

const double cos_smooth = std::cos(glm::radians(30.0));
constexpr float same_uv = 1e-5f; // a tenth of a pixel of the largest textures

template <class T> bool equal_at(const std::vector<T>& values, std::uint32_t v, std::uint32_t w)
{
    return values.empty() || values[v] == values[w];
}

bool same_motion(const Mesh& mesh, std::uint32_t v, std::uint32_t w)
{
    return equal_at(mesh.influences, v, w) &&
           std::ranges::all_of(mesh.morph_targets, [&](const Mesh::MorphTarget& target) {
               return equal_at(target.positions, v, w);
           });
}

bool all_equal(const Mesh& mesh, std::uint32_t v, std::uint32_t w)
{
    return mesh.positions[v] == mesh.positions[w] && equal_at(mesh.normals, v, w) &&
           equal_at(mesh.tangents, v, w) && equal_at(mesh.colors, v, w) &&
           std::ranges::all_of(mesh.uvs, [&](const auto& set) { return set[v] == set[w]; }) &&
           same_motion(mesh, v, w) &&
           std::ranges::all_of(mesh.morph_targets, [&](const Mesh::MorphTarget& target) {
               return equal_at(target.normals, v, w) && equal_at(target.tangents, v, w);
           });
}

} // namespace

std::vector<std::uint32_t> first_equal_vertices(const Mesh& mesh)
{
    std::vector<std::uint32_t> first(mesh.vertex_count());
    std::iota(first.begin(), first.end(), 0u);
    if (mesh.points.empty()) return first;
    // The different values of a point form a list; the number of comparisons is limited to what
    // meshes made for display need.
    constexpr std::uint32_t none = ~0u;
    constexpr int most_compared = 64;
    std::vector<std::uint32_t> list(point_count(mesh), none), next(mesh.vertex_count(), none);
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        std::uint32_t* at = &list[mesh.points[v]];
        int compared = 0;
        while (*at != none && !all_equal(mesh, *at, v) && ++compared < most_compared)
            at = &next[*at];
        if (*at == none)
            *at = v;
        else if (compared < most_compared)
            first[v] = *at;
    }
    return first;
}

bool smooth(const Mesh& mesh, std::uint32_t v, std::uint32_t w)
{
    return mesh.normals.empty() || mesh.normals[v] == mesh.normals[w] ||
           glm::dot(glm::dvec3(mesh.normals[v]), glm::dvec3(mesh.normals[w])) >= cos_smooth;
}

bool alike(const Mesh& mesh, std::uint32_t v, std::uint32_t w)
{
    if (v == w) return true;
    return smooth(mesh, v, w) && equal_at(mesh.colors, v, w) && same_motion(mesh, v, w) &&
           std::ranges::all_of(mesh.uvs, [&](const auto& set) {
               return glm::all(glm::lessThanEqual(glm::abs(set[v] - set[w]), glm::vec2(same_uv)));
           });
}

} // namespace trivar

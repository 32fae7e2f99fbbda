// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/kept_vertices.h"

namespace trivar {
namespace {

// Makes the tangent orthogonal to the normal.
glm::vec4 straightened(const glm::vec4& tangent, const glm::vec3& normal)
{
    const glm::vec3 along(tangent), across = along - normal * glm::dot(normal, along);
    const float length = glm::length(across);
    return length > 0 ? glm::vec4(across / length, tangent.w) : tangent;
}

} // namespace

std::uint32_t KeptVertices::number(std::uint32_t vertex, const glm::vec3& normal)
{
    const auto fresh = static_cast<std::uint32_t>(made_.size());
    std::uint32_t* at = &list_[vertex];
    while (*at != none && made_[*at].normal != normal) at = &made_[*at].next;
    if (*at != none) return *at;
    *at = fresh;
    made_.push_back({vertex, normal, none});
    return fresh;
}

void KeptVertices::write(Mesh& out, std::vector<std::uint32_t>& numbers) const
{
    std::vector<std::uint32_t> order, now_at(made_.size());
    order.reserve(made_.size());
    for (const std::uint32_t first : list_)
        for (std::uint32_t n = first; n != none; n = made_[n].next) {
            now_at[n] = static_cast<std::uint32_t>(order.size());
            order.push_back(n);
        }
    for (std::uint32_t& n : out.corners) n = now_at[n];
    for (std::uint32_t& n : numbers) n = now_at[n];
    const auto kept = [&](const auto& values) {
        std::decay_t<decltype(values)> some;
        if (values.empty()) return some;
        some.reserve(order.size());
        for (const std::uint32_t n : order) some.push_back(values[made_[n].vertex]);
        return some;
    };
    out.positions = kept(mesh_.positions);
    out.tangents = kept(mesh_.tangents);
    out.colors = kept(mesh_.colors);
    out.influences = kept(mesh_.influences);
    for (const auto& set : mesh_.uvs) out.uvs.push_back(kept(set));
    for (const Mesh::MorphTarget& target : mesh_.morph_targets)
        out.morph_targets.push_back(
            {kept(target.positions), kept(target.normals), kept(target.tangents)});
    write_points(out, order);
    if (mesh_.normals.empty()) return;
    for (const std::uint32_t n : order) out.normals.push_back(made_[n].normal);
    for (std::size_t v = 0; v < out.tangents.size(); ++v)
        if (out.normals[v] != mesh_.normals[made_[order[v]].vertex])
            out.tangents[v] = straightened(out.tangents[v], out.normals[v]);
}

// Writes the points, numbered from 0 without gaps; none if each vertex is a point.
void KeptVertices::write_points(Mesh& out, const std::vector<std::uint32_t>& order) const
{
    std::vector<std::uint32_t> number(mesh_.vertex_count(), none);
    std::uint32_t count = 0;
    for (const std::uint32_t n : order) {
        std::uint32_t& point = number[mesh_.point(made_[n].vertex)];
        if (point == none) point = count++;
        out.points.push_back(point);
    }
    if (count == order.size()) out.points.clear();
}

} // namespace trivar

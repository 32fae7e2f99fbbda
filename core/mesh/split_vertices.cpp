// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/split_vertices.h"

#include <numeric>

namespace trivar {

void take_vertices(Mesh& mesh, const std::vector<std::uint32_t>& from)
{
    const auto take = [&](auto& values) {
        if (values.empty()) return;
        std::remove_reference_t<decltype(values)> taken;
        taken.reserve(from.size());
        for (const std::uint32_t v : from) taken.push_back(values[v]);
        values = std::move(taken);
    };
    if (mesh.points.empty() && from.size() > mesh.vertex_count()) { // each was its own point
        mesh.points.resize(mesh.vertex_count());
        std::iota(mesh.points.begin(), mesh.points.end(), 0u);
    }
    if (!mesh.creases.empty()) {
        std::vector<std::uint32_t> first_of(mesh.vertex_count());
        for (std::size_t v = from.size(); v-- > 0;)
            first_of[from[v]] = static_cast<std::uint32_t>(v);
        for (Mesh::Crease& crease : mesh.creases)
            crease.a = first_of[crease.a], crease.b = first_of[crease.b];
    }
    take(mesh.points);
    take(mesh.positions);
    take(mesh.normals);
    take(mesh.tangents);
    take(mesh.colors);
    for (auto& set : mesh.uvs) take(set);
    take(mesh.influences);
    for (Mesh::MorphTarget& target : mesh.morph_targets) {
        take(target.positions);
        take(target.normals);
        take(target.tangents);
    }
}

void renumber_points(std::vector<std::uint32_t>& points, std::size_t count_before)
{
    const std::uint32_t none = ~0u;
    std::vector<std::uint32_t> now(count_before, none);
    std::uint32_t count = 0;
    for (std::uint32_t& point : points) {
        if (now[point] == none) now[point] = count++;
        point = now[point];
    }
}

Mesh without_loose_vertices(Mesh mesh)
{
    std::vector<bool> used(mesh.vertex_count(), false);
    for (const std::uint32_t v : mesh.corners) used[v] = true;
    std::vector<std::uint32_t> kept, now_at(mesh.vertex_count());
    for (std::uint32_t v = 0; v < used.size(); ++v) {
        now_at[v] = static_cast<std::uint32_t>(kept.size());
        if (used[v]) kept.push_back(v);
    }
    if (kept.size() == mesh.vertex_count()) return mesh;
    std::erase_if(mesh.creases, [&](const Mesh::Crease& c) { return !used[c.a] || !used[c.b]; });
    const std::size_t points = point_count(mesh);
    take_vertices(mesh, kept);
    renumber_points(mesh.points, points);
    for (std::uint32_t& v : mesh.corners) v = now_at[v];
    return mesh;
}

} // namespace trivar

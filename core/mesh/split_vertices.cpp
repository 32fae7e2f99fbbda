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

} // namespace trivar

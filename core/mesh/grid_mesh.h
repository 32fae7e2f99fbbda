// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <array>

namespace trivar {

struct GridVertex {
    glm::dvec3 position, normal;
    glm::dvec2 uv;
};

// Appends a grid of cells.x by cells.y quads whose vertex (i, j) is vertex_at(i, j); seen from
// the side the normals point to, i goes right and j up, or the other way round with `turned`. A
// quad with a collapsed side becomes a triangle.
template <class VertexAt>
void append_grid(Mesh& mesh, glm::ivec2 cells, VertexAt vertex_at, bool turned = false)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    if (mesh.uvs.empty()) mesh.uvs.emplace_back();
    for (int i = 0; i <= cells.x; ++i)
        for (int j = 0; j <= cells.y; ++j) {
            const GridVertex vertex = vertex_at(i, j);
            mesh.positions.push_back(glm::vec3(vertex.position) + 0.0f); // no negative zeros
            mesh.normals.push_back(glm::vec3(vertex.normal) + 0.0f);
            mesh.uvs[0].push_back(glm::vec2(vertex.uv));
        }
    const auto at = [&](int i, int j) {
        return first + static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(cells.y + 1) +
               static_cast<std::uint32_t>(j);
    };
    for (int i = 0; i < cells.x; ++i)
        for (int j = 0; j < cells.y; ++j) {
            std::array quad{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            if (turned) std::swap(quad[1], quad[3]);
            std::array<std::uint32_t, 4> kept{};
            std::size_t count = 0;
            for (const std::uint32_t v : quad)
                if (count == 0 || mesh.positions[kept[count - 1]] != mesh.positions[v])
                    kept[count++] = v;
            if (count > 1 && mesh.positions[kept[count - 1]] == mesh.positions[kept[0]]) --count;
            if (count >= 3) add_face(mesh, std::span(kept).first(count));
        }
}

// Welds equal positions to points and removes the vertices that collapsed sides left over.
inline Mesh finished_grids(Mesh mesh)
{
    mesh = without_loose_vertices(std::move(mesh));
    mesh.points = points_by_position(mesh.positions);
    return mesh;
}

} // namespace trivar

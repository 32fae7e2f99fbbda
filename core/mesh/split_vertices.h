// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/vertex_corners.h"

#include <algorithm>

namespace trivar {

// Gives the mesh other vertices: v gets all that vertex from[v] had. Corners are left as they are,
// creases name the first copies, and copies are one point.
void take_vertices(Mesh& mesh, const std::vector<std::uint32_t>& from);

// Gives the vertices values of which there is one per corner, #C: a vertex whose corners have
// several becomes one vertex for each, which have all else in common and are one point. They follow
// each other in the order of their first corners. Returns the values of the new vertices; a vertex
// of no face gets `otherwise`. O(#C log valence).
template <class T>
std::vector<T> split_vertices(Mesh& mesh, const std::vector<T>& at_corners, const T& otherwise)
{
    const std::size_t before = mesh.vertex_count();
    const VertexCorners round(mesh.corners, before);
    std::vector<std::uint32_t> from, order;
    std::vector<T> values;
    for (std::uint32_t v = 0; v < before; ++v) {
        const std::size_t first = values.size();
        order.assign(round[v].begin(), round[v].end());
        std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
            for (int i = 0; i < T::length(); ++i)
                if (at_corners[a][i] != at_corners[b][i])
                    return at_corners[a][i] < at_corners[b][i];
            return a < b;
        });
        // Each corner names the first one with its value, and then in their order its vertex.
        for (std::size_t i = 0; i < order.size(); ++i)
            mesh.corners[order[i]] = i > 0 && at_corners[order[i]] == at_corners[order[i - 1]]
                                         ? mesh.corners[order[i - 1]]
                                         : order[i];
        for (const std::uint32_t c : round[v]) {
            std::uint32_t& vertex = mesh.corners[c];
            if (vertex == c) values.push_back(at_corners[c]);
            vertex =
                vertex == c ? static_cast<std::uint32_t>(values.size() - 1) : mesh.corners[vertex];
        }
        if (values.size() == first) values.push_back(otherwise);
        from.resize(values.size(), v);
    }
    if (from.size() > before) take_vertices(mesh, from);
    return values;
}

} // namespace trivar

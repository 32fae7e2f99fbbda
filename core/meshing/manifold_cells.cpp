// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/manifold_cells.h"

#include "core/simplex/cell_faces.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

// Joins the faces around one vertex that meet in an edge, and counts the parts.
std::size_t fan_count(int vertex, const std::vector<int>& faces,
                      const std::vector<std::array<int, 3>>& border)
{
    struct Side {
        int other; // end of an edge from the vertex
        std::size_t face;
    };
    std::vector<Side> sides;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const int v : border[static_cast<std::size_t>(faces[f])])
            if (v != vertex) sides.push_back({v, f});
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.other != b.other ? a.other < b.other : a.face < b.face;
    });
    std::vector<std::size_t> leader(faces.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](std::size_t f) {
        while (leader[f] != f) f = leader[f];
        return f;
    };
    for (std::size_t s = 0; s + 1 < sides.size(); ++s)
        if (sides[s].other == sides[s + 1].other)
            leader[find(sides[s].face)] = find(sides[s + 1].face);
    std::size_t count = 0;
    for (std::size_t f = 0; f < leader.size(); ++f) count += leader[f] == f ? 1 : 0;
    return count;
}

} // namespace

std::vector<std::array<int, 3>> border_faces(const SimplexMesh<3>& mesh,
                                             const std::vector<bool>& chosen)
{
    SimplexDomain<3> domain;
    for (std::size_t c = 0; c < chosen.size(); ++c)
        if (chosen[c]) domain.cells.push_back(mesh.cells[c]);
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    std::vector<std::array<int, 3>> out;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (f + 1 < faces.size() && faces[f].vertices == faces[f + 1].vertices)
            ++f;
        else
            out.push_back(faces[f].vertices);
    return out;
}

std::vector<bool> with_manifold_border(const SimplexMesh<3>& mesh, std::vector<bool> chosen)
{
    const std::vector<std::vector<int>> stars = vertex_stars(mesh);
    for (bool added = true; added;) {
        added = false;
        const auto add = [&](int cell) {
            added = added || !chosen[static_cast<std::size_t>(cell)];
            chosen[static_cast<std::size_t>(cell)] = true;
        };
        const std::vector<std::array<int, 3>> border = border_faces(mesh, chosen);
        std::vector<std::array<int, 2>> edges;
        std::vector<std::vector<int>> at(mesh.vertices.size());
        for (std::size_t f = 0; f < border.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i) {
                at[static_cast<std::size_t>(border[f][i])].push_back(static_cast<int>(f));
                edges.push_back({border[f][i == 2 ? 0 : i], border[f][i == 2 ? 2 : i + 1]});
            }
        std::sort(edges.begin(), edges.end());
        for (std::size_t e = 0; e + 2 < edges.size(); ++e) // 2 or 4 faces at each edge, or more
            if (edges[e] == edges[e + 2])
                for (const int c : stars[static_cast<std::size_t>(edges[e][0])])
                    for (const int v : mesh.cells[static_cast<std::size_t>(c)])
                        if (v == edges[e][1]) add(c);
        if (added) continue;
        for (std::size_t v = 0; v < at.size(); ++v)
            if (at[v].size() > 3 && fan_count(static_cast<int>(v), at[v], border) > 1)
                for (const int c : stars[v]) add(c);
    }
    return chosen;
}

} // namespace trivar

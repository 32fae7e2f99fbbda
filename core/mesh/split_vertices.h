// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/mesh/vertex_corners.h"

#include <algorithm>
#include <numeric>

namespace trivar {

// Gives the vertices values of which some have several: one for each of their corners that are
// listed, in ascending order, as all corners of a vertex are or none. Such a vertex becomes one
// vertex for each of its values, which have all else in common and are one point; they follow each
// other in the order of their first corners. Returns the values of the new vertices. O(#C log
// valence).
template <class T>
std::vector<T> split_vertices(Mesh& mesh, std::vector<T> values,
                              const std::vector<std::uint32_t>& corners,
                              const std::vector<T>& at_corners)
{
    if (corners.empty()) return values;
    std::vector<std::uint32_t> vertices;
    vertices.reserve(corners.size());
    for (const std::uint32_t c : corners) vertices.push_back(mesh.corners[c]);
    const VertexCorners round(vertices, mesh.vertex_count());
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        for (int i = 0; i < T::length(); ++i)
            if (at_corners[a][i] != at_corners[b][i]) return at_corners[a][i] < at_corners[b][i];
        return a < b;
    };
    std::vector<std::uint32_t> from, now(mesh.vertex_count()), order, first(corners.size());
    std::vector<T> out;
    out.reserve(values.size());
    for (std::uint32_t v = 0; v < now.size(); ++v) {
        now[v] = static_cast<std::uint32_t>(from.size());
        const std::span<const std::uint32_t> here = round[v];
        constexpr std::size_t few = 12;
        if (here.size() <= few) {
            for (const std::uint32_t& i : here) {
                const std::uint32_t* same = here.data();
                while (same != &i && at_corners[*same] != at_corners[i]) ++same;
                first[i] = *same;
            }
        } else {
            order.assign(here.begin(), here.end());
            std::ranges::sort(order, less);
            for (std::size_t i = 0; i < order.size(); ++i)
                first[order[i]] = i > 0 && at_corners[order[i]] == at_corners[order[i - 1]]
                                      ? first[order[i - 1]]
                                      : order[i];
        }
        // Each place in the list has the first one with its value; from there on its vertex.
        for (const std::uint32_t i : here) {
            if (first[i] != i) {
                first[i] = first[first[i]];
                continue;
            }
            first[i] = static_cast<std::uint32_t>(from.size());
            from.push_back(v);
            out.push_back(at_corners[i]);
        }
        if (!here.empty()) continue;
        from.push_back(v);
        out.push_back(values[v]);
    }
    for (std::uint32_t& v : mesh.corners) v = now[v];
    for (std::size_t i = 0; i < corners.size(); ++i) mesh.corners[corners[i]] = first[i];
    if (from.size() > now.size()) take_vertices(mesh, from);
    return out;
}

// The same with values for all corners, #C; a vertex of no face gets `otherwise`.
template <class T>
std::vector<T> split_vertices(Mesh& mesh, const std::vector<T>& at_corners, const T& otherwise)
{
    std::vector<std::uint32_t> all(at_corners.size());
    std::iota(all.begin(), all.end(), 0u);
    return split_vertices(mesh, std::vector<T>(mesh.vertex_count(), otherwise), all, at_corners);
}

} // namespace trivar

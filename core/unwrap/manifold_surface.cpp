// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/manifold_surface.h"

#include <algorithm>
#include <numeric>

namespace trivar {

ManifoldSurface::ManifoldSurface(const Mesh& mesh)
    : mesh_(mesh),
      adjacency_(mesh),
      takes_part_(mesh.face_count(), 1),
      vertex_(mesh.corners.size(), none),
      behind_(mesh.corners.size(), none)
{
    std::vector<std::uint32_t> points; // of a face
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        points.clear();
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            points.push_back(adjacency_.point(c));
        std::ranges::sort(points);
        takes_part_[f] = std::ranges::adjacent_find(points) == points.end();
        left_out_ += !takes_part_[f];
    }
    for (std::size_t e = 0; e < adjacency_.edge_count(); ++e) {
        if (!adjacency_.is_manifold(e)) continue;
        const auto sides = adjacency_.sides(e);
        const std::uint32_t f = adjacency_.face(sides[0]), g = adjacency_.face(sides[1]);
        if (f == g || !takes_part_[f] || !takes_part_[g]) continue;
        behind_[sides[0]] = sides[1];
        behind_[sides[1]] = sides[0];
    }
    // Corners are one vertex where faces can be crossed side by side from one to the other.
    std::vector<std::uint32_t> leader(mesh.corners.size());
    std::iota(leader.begin(), leader.end(), 0u);
    const auto find = [&](std::uint32_t c) {
        while (leader[c] != c) c = leader[c] = leader[leader[c]];
        return c;
    };
    for (std::uint32_t side = 0; side < behind_.size(); ++side) {
        if (behind_[side] == none) continue;
        const std::uint32_t a = find(side), b = find(adjacency_.next(behind_[side]));
        leader[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) {
        const std::uint32_t first = find(c);
        if (first == c)
            vertex_[c] = static_cast<std::uint32_t>(vertex_count_++);
        else
            vertex_[c] = vertex_[first];
    }
}

} // namespace trivar

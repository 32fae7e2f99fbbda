// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/adjacency.h"

namespace trivar {

// A ManifoldSurface is a mesh as it is cut into charts: a surface that is manifold everywhere.
// Where edges have other than two faces, which run along them in opposite directions, and where
// faces touch in nothing but a point, it is split; faces that use a point twice are left out. O(#C
// log valence).
class ManifoldSurface {
public:
    explicit ManifoldSurface(const Mesh& mesh);

    static constexpr std::uint32_t none = ~0u;
    const Mesh& mesh() const { return mesh_; }
    const Adjacency& adjacency() const { return adjacency_; }
    bool takes_part(std::size_t face) const { return takes_part_[face]; }
    std::size_t left_out() const { return left_out_; }
    // The vertices of the split surface, by corner of the mesh.
    std::uint32_t vertex(std::uint32_t corner) const { return vertex_[corner]; }
    std::size_t vertex_count() const { return vertex_count_; }
    // The side behind a side, by their corners; none: the surface ends there.
    std::uint32_t behind(std::uint32_t side) const { return behind_[side]; }

private:
    const Mesh& mesh_;
    Adjacency adjacency_;
    std::vector<char> takes_part_;
    std::size_t left_out_ = 0, vertex_count_ = 0;
    std::vector<std::uint32_t> vertex_, behind_;
};

} // namespace trivar

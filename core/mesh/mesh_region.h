// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A MeshRegion is some faces of a mesh as a mesh of their own, to be changed and put back.
struct MeshRegion {
    Mesh mesh;                           // of faces and their vertices, both in their order
    std::vector<std::uint32_t> faces;    // of the whole, ascending, by face of the region
    std::vector<std::uint32_t> vertices; // of the whole, ascending, by vertex of the region
    std::vector<std::uint32_t> points;   // of the whole, by point of the region
    std::size_t whole_points = 0;        // number of points of the whole
};

// Takes faces (ascending) out of a mesh with that number of points. O(#V) to mark them, and the
// work of the region.
MeshRegion region_of(const Mesh& whole, std::size_t points, std::vector<std::uint32_t> faces);

// Makes `out` a copy of a mesh without some of its faces (`left_out`, ascending), in their order:
// with room for more vertices and for so many more triangles, with a point for every vertex. The
// memory of `out` is used again. Arrays in parallel.
void copy_others(Mesh& out, const Mesh& mesh, const std::vector<std::uint32_t>& left_out,
                 std::size_t more_vertices, std::size_t more_triangles);

// Puts a changed region into a copy of the whole without the region's faces, as copy_others() makes
// it. The first vertices of `changed` are still those of the region and take their places; others,
// and all faces, come last. Points from the region's number on are new ones. O(size of the region),
// arrays in parallel.
void put_back(Mesh& out, const MeshRegion& region, const Mesh& changed);

} // namespace trivar

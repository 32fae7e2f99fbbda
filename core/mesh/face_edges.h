// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// FaceEdges finds facts about the faces of a mesh by their edges. An edge lies between points, so
// that both sides of a seam are one edge. O(#C log valence).
struct FaceEdges {
    explicit FaceEdges(const Mesh& mesh);

    // Neighbours are two faces that share an edge with no third face. None are listed where no two
    // are against each other.
    struct Neighbours {
        std::uint32_t a, b;
        bool against; // both have the edge in the same direction
    };
    std::vector<Neighbours> neighbours;
    std::vector<std::uint32_t> border;  // points at the ends of edges with one face
    std::vector<std::uint32_t> crowded; // faces that share an edge and its direction with others
    std::vector<std::uint32_t> part_of; // #F: what hangs together by neighbours, from 0 up
    std::size_t parts = 0;
    std::vector<bool> open; // #parts: an edge has not just two faces
};

} // namespace trivar

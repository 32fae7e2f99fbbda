// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_error.h"

namespace trivar {

// A FineMesh is a mesh that is fine enough to be parted.
struct FineMesh {
    Mesh mesh;
    std::vector<double> heights; // #V x #openings: over each cut surface
    // Metres: bounds of the distance of its triangles from the true ones, of those that are not cut
    // and of those that are.
    double off = 0, cut_off = 0;
};

// Splits the triangles near the openings of a field, at the middles of their edges, until none is
// off by more than the tolerance (metres; those that are cut by less), or until `most_triangles`
// are there. Positions are in the world. Faces are triangles then. No cracks: an edge is split for
// both of its triangles, and only where one of its ends is `free` (by point). The mesh has
// `points`. O(#V + #C) and the work at the openings.
FineMesh fine_enough(Mesh mesh, std::vector<char> free, const SplitField& field,
                     const SplitError& error, double tolerance, std::size_t most_triangles);

// Computes the heights of the vertices that have none yet.
void add_heights(std::vector<double>& heights, const Mesh& mesh, const SplitField& field);

} // namespace trivar

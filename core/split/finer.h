// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_error.h"

namespace trivar {

// A FineMesh is a mesh that is fine enough to be parted.
struct FineMesh {
    Mesh mesh;
    std::vector<double> heights; // #V x #openings: over each cut surface
    // Upper bounds, in metres, of the distance between triangles and the true surface: for uncut
    // and for cut triangles.
    double off = 0, cut_error = 0;
};

// Splits the triangles near the openings of a field, at the middles of their edges, until all are
// fine enough.
//   mesh            world; it has `points`. Faces of the result are triangles
//   free            by point: an edge is split only if one of its ends is free
//   tolerance       metres; cut triangles keep within less
//   most_triangles  at which it stops
// No cracks: an edge is split for both of its triangles. O(#V + #C) and the work at the openings.
FineMesh fine_enough(Mesh mesh, std::vector<char> free, const SplitField& field,
                     const SplitError& error, double tolerance, std::size_t most_triangles);

// Computes the heights of the vertices that have none yet.
void add_heights(std::vector<double>& heights, const Mesh& mesh, const SplitField& field);

} // namespace trivar

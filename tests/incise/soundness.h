// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/incise.h"

namespace trivar::testing {

// SlitFaults counts the faults of a cut mesh; all 0 for a sound one.
struct SlitFaults {
    std::size_t open = 0;    // directed edges without an opposite one
    std::size_t twice = 0;   // directed edges of two faces
    std::size_t pinched = 0; // points round which faces are not one cycle
    long euler = 0;          // change of the Euler number
    std::size_t lost = 0;    // vertices of the original that no face uses any more
    double volume = 0;       // change at rest, as a share of the cube of the diagonal
    bool none() const { return open == 0 && twice == 0 && pinched == 0 && euler == 0 && lost == 0; }
};

// Counted over the whole mesh, without what the original has itself (rims of scans).
SlitFaults faults_of(const IncisedMesh& made);

// The volume within each connected part, ascending; that of a shell has two skins, of a sphere one.
std::vector<double> volumes_of_parts(const Mesh& mesh);

// Vertices of one point that do not have the same position to the bit.
std::size_t copies_apart(const Mesh& mesh);

// Pairs of triangles, near the cuts, that pierce each other at some openings and do not at rest.
// Counted with moves in doubles: where a gap is as narrow as a rounding error, floats touch.
std::size_t piercings_at(const IncisedMesh& made, std::span<const IncisionOpening> openings);

} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cap_options.h"
#include "core/split/cut.h"

namespace trivar {

struct Caps {
    std::size_t first_vertex = 0; // of those of caps; all later ones are
    std::size_t first_face = 0;   // of caps; all later ones are
    // The parameters of each of those vertices, in their order.
    std::vector<glm::dvec2> parameters;
    // Number of loops that were closed by triangles round one point each, since loops cross.
    std::size_t fans = 0;
    std::size_t open = 0; // number of edges of the cut that are on no loop, as those of a sheet
    std::size_t gaps = 0; // number of loops that go across gaps, since the mesh was open there
};

// Closes both halves of a cut mesh with caps: one constrained Delaunay triangulation of the rim's
// loops, holes and nested loops included, for both halves. The part below is capped by faces that
// look up, the part above by the same turned round. Vertices of caps are new ones, at the points of
// the rim; their first texture coordinates are the parameters, and `above` says to which half they
// belong. O(n log n). [Schein, thesis, 6.3]
Caps cap(CutMesh& cut, const CapOptions& options);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cut.h"
#include "core/split/fine_triangles.h"

#include <functional>

namespace trivar {

// How the holes that a cut leaves are closed.
struct CapOptions {
    // Where each place lies on the cut surface, by two parameters in metres (v, w). With the
    // direction in which the function of the cut grows they are right-handed.
    std::vector<glm::dvec2> places;
    // The point of the cut surface at two parameters, and its unit normal toward the part above.
    std::function<glm::dvec3(const glm::dvec2&)> point;
    std::function<glm::dvec3(const glm::dvec2&)> normal;
    // Triangles that are too coarse get points inside; null: none is. Those without an inner edge
    // longer than 1/1000 of the cap's size stay as they are.
    Coarseness coarseness = nullptr;
    std::uint32_t material = 0; // face_material of the caps
};

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
// the rim; their first texture coordinates are the parameters, and `above` says of which half they
// are. O(n log n). [Schein, thesis, 6.3]
Caps cap(CutMesh& cut, const CapOptions& options);

} // namespace trivar

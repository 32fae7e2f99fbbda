// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace trivar {

// A CellLattice divides a tetrahedron whose corners have an order into steps^3 smaller ones [1];
// cells that meet in a face and order its corners alike divide it alike. Each piece is oriented as
// the corners in their order are.
//   [1] Freudenthal, Simplizialzerlegungen von beschraenkter Flachheit, 1942
struct CellLattice {
    explicit CellLattice(int steps);

    int steps;
    std::vector<std::array<int, 4>> points; // steps times the barycentric coordinates
    std::vector<std::array<int, 4>> pieces; // of points
    // The triangles of the face opposite to each corner, turned outward where the corners are of
    // positive orientation.
    std::array<std::vector<std::array<int, 3>>, 4> faces;
};

// The corners of a face opposite to corner k of a tetrahedron of positive orientation, turned
// outward.
inline constexpr std::array<std::array<int, 3>, 4> outward_faces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

} // namespace trivar

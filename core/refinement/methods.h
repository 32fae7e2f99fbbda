// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// How far a mapped triangle (edge) may be from the flat one through its mapped corners, point for
// point of equal barycentric coordinates. M1, M2, M3 are the greatest lengths of the second
// derivatives D_pp, D_pq, D_qq of the map, p and q being two edges of the triangle.
//
// The first three are those of S. Schein's thesis (Technion 2006), kept for comparison:
enum class BoundMethod {
    thesis_right_angled, // 1/8 (M1 + 2 M2 + M3): legs along parameter axes, else infinite. Theorem
                         // 4
    thesis,              // 1/2 (M1 + 2 M2 + M3) for any triangle: true, 4 times more than needed
    thesis_circumradius, // R^2/2 (M1 + M2/2 + M3), p and q orthonormal. FALSE: it bounds nothing
    barycentric,  // 1/8 (M1 + 2 M2 + M3), any triangle: in barycentric coordinates all are right
    best_corner,  // the least of the three
    circumradius, // R^2/2 (M1 + M2 + M3), p and q orthonormal
    waldron,      // r^2/2 M, r of the smallest circle round it. Waldron, SIAM J. Num. An. 1998
    net_affine,   // control net over the triangle's box less an affine map through the corners
    composed_net, // Bezier net of the error itself, cell by cell: the one to use
    composed_net_subdivided, // the same after every piece was cut in four
};

// Where an edge is split, at a fifth of its length from either end at least.
enum class SplitPoint {
    equidistributed, // equal halves of the integral of |E''|^(1/2): best for piecewise linear maps
    midpoint,
    greville,       // the node of its net's control point that is furthest off. The thesis, 2.4.2
    greatest_error, // where the edge is furthest off
};

enum class RefinementRule {
    edge_driven, // edges that are off, and the worst edge of a triangle that is: ours
    // For comparison only:
    thesis_four_split,     // a triangle that is off goes into four; its neighbours follow
    chua_neumann_midpoint, // an edge whose middle is off. NOT certified. Chua and Neumann 2000
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// A method bounds the distance of a mapped triangle (or edge) from the flat one through its mapped
// corners, point for point of equal barycentric coordinates. M1, M2, M3 are the greatest lengths of
// the second derivatives D_pp, D_pq, D_qq of the map, p and q being two edges of the triangle.
//
// The first three are those of S. Schein's thesis (Technion 2006), kept for comparison:
enum class BoundMethod {
    thesis_right_angled, // 1/8 (M1 + 2 M2 + M3): legs along parameter axes, else infinite. Theorem
                         // 4
    thesis,              // 1/2 (M1 + 2 M2 + M3) for any triangle: true, 4 times more than needed
    thesis_circumradius, // R^2/2 (M1 + M2/2 + M3), p and q orthonormal. FALSE: it bounds nothing
    // 1/8 (M1 + 2 M2 + M3) for any triangle: every triangle is right-angled in barycentric
    // coordinates
    barycentric,
    best_corner,  // the least of 1/8 (M1 + 2 M2 + M3) with p and q from each of the three corners
    circumradius, // R^2/2 (M1 + M2 + M3), p and q orthonormal
    waldron, // r^2/2 M, r of the smallest circle round the triangle. Waldron, SIAM J. Num. An. 1998
    net_affine,   // control net over the triangle's box minus an affine map through the corners
    composed_net, // Bezier net of the error itself, cell by cell: the default
    composed_net_subdivided, // the same with every piece cut in four first
};

// A SplitPoint says where an edge is split: at least a fifth of its length from either end.
enum class SplitPoint {
    equidistributed, // equal halves of the integral of |E''|^(1/2): best for piecewise linear maps
    midpoint,
    greville, // the node of the control point of its net that is furthest off. The thesis, 2.4.2
    greatest_error, // where the error of the edge is greatest
};

enum class RefinementRule {
    // splits edges beyond the tolerance, and the worst edge of a triangle beyond it: ours
    edge_driven,
    // The two rules below serve comparison only.
    thesis_four_split, // splits a triangle beyond the tolerance into four; its neighbours follow
    // splits an edge whose middle is beyond the tolerance. NOT certified. Chua and Neumann 2000
    chua_neumann_midpoint,
};

} // namespace trivar

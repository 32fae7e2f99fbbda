// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/refinement/cubic_error.h"

#include <optional>

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

// Certified bounds in world units: what they promise holds for exact arithmetic, and the bound is
// raised by what rounding may hide in its own computation. Infinite where a method says nothing:
// all where the map jumps inside, the ones by second derivatives also where it has a kink (a knot
// of an axis of order 2, the end of an open axis). Remembers the last cell: one for each thread.
class ErrorBounds {
public:
    explicit ErrorBounds(Ref<DisplacementCells> cells) : cells_(std::move(cells)) {}

    // Corners with the displacement there: evaluate(displacement, uvw).value.
    struct Corner {
        glm::dvec3 uvw, displacement;
    };
    Corner corner(const glm::dvec3& uvw) const;
    double triangle(const std::array<Corner, 3>& corners, BoundMethod method);
    double edge(const std::array<Corner, 2>& corners, BoundMethod method);

    // The displacement along an edge as the Bezier nets of its pieces.
    struct EdgePiece {
        double from, to; // of the edge, 0 to 1
        int degree;
        std::array<glm::dvec4, 16> net;
    };
    std::vector<EdgePiece> edge_pieces(const std::array<Corner, 2>& corners);

    const DisplacementCells& cells() const { return *cells_; }

private:
    template <int corners> struct Piece;
    template <int corners> struct Work;
    const DisplacementCells::Cell& cell(const glm::ivec3& slabs);

    Ref<DisplacementCells> cells_;
    DisplacementCells::Cell cell_;
    bool loaded_ = false;
    std::optional<CubicError> cubic_; // of that cell
};

// The least circle round a triangle, and the one through its corners: radii in the units of p.
double least_circle_radius(const std::array<glm::dvec3, 3>& p);
double circumradius(const std::array<glm::dvec3, 3>& p);

} // namespace trivar

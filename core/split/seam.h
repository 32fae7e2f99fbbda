// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cut.h"
#include "core/split/split_field.h"

namespace trivar {

// A Seam is where the skin beside an opening is drawn in along w, so that the lips of each half
// meet. With the height h over the cut surface, the share x = |h| / R of the reach, and E(v), which
// grows from 0 at both ends of the opening to 1 before its halves part,
//
//   w' = w + (1 - x)^2 E(v) (T(w) - w),   u' = h + phi(v, w').
//
// R is a share of the opening's reach: the skin is drawn into a hole, not into a trough.
//
// T never falls, so no line along w is turned round and nothing folds; and a point stays on its
// side of the cut surface, as high above it, so that it is parted afterwards like any other.
// [Schein, thesis, 6.3, where control points of the cut are moved to one w]
inline constexpr double drawn_reach = 0.3; // R, of the reach of the opening
struct Seam {
    struct Knot {
        double w, target, slope;
    };
    // T is the cubic between these, and w beyond the first and the last. Empty: nothing is drawn.
    std::vector<Knot> knots;
    glm::dvec2 way{0}; // the ends of the opening along v
    double ends = 1;   // metres from either of them over which E grows

    struct Slope {
        double value, slope;
    };
    Slope target(double w) const; // T
    Slope share(double v) const;  // E
    bool draws() const { return !knots.empty(); }
};

// Bounds over an interval.
struct SeamBound {
    double lo, hi;           // where T leads
    double most = 0;         // |T - w|
    double slope = 1;        // T'
    double slope_less_1 = 0; // |T' - 1|
    double bend = 0;         // |T''|
    double kink = 0;         // by how much T' jumps
};
SeamBound bound(const Seam& seam, double w_from, double w_to);
struct ShareBound {
    double least, value, first, second; // of E and its derivatives, absolute
};
ShareBound share_bound(const Seam& seam, double v_from, double v_to);

// The seam of a mesh that was cut along a cut surface. Loops of its rim that overlap along w, or
// all but do, have one place at which they are sewn: the mean w of their edges that are in the
// opening; where the opening ends within the mesh, its end, where both halves meet. No loop is
// drawn in where the opening ends too near to the skin, or where it ends on both sides within the
// mesh.
Seam seam_of(const CutMesh& cut, const SplitField& field, std::size_t opening);

// A point that was drawn in by the seams of a field, if by any, and the derivatives of its u and w
// by (u, v, w). No point is in reach of more than one opening. `sides` and `on` are those of
// SplitField::moved().
struct DrawnIn {
    glm::dvec3 uvw;
    glm::dvec3 u{1, 0, 0}, w{0, 0, 1};
};
DrawnIn drawn_in(const SplitField& field, std::span<const Seam> seams, const glm::dvec3& uvw,
                 std::span<const char> sides, std::span<const char> on);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/trivariate.h"

#include <glm/glm.hpp>
#include <span>

namespace trivar {

// A Lattice is a free-form deformation volume: F(uvw) = rest(uvw) + sum_ijk N_ijk(uvw) D_ijk.
// Control points are stored as displacements D from their places at rest, which are the images of
// their Greville abscissae by the affine map `rest`. A lattice of zeros is exactly `rest`, for
// B-splines reproduce affine maps. One axis of order 3 with five control points:
//
//      knots  |       |       |       |     0 0 0 1/3 2/3 1 1 1: three cells
//   Greville  o   o       o       o   o     0 1/6 1/2 5/6 1: where the control points rest
struct Lattice {
    Trivariate<glm::dvec3> displacement;
    glm::dmat4 rest{1}; // uvw to world, affine

    bool operator==(const Lattice&) const = default;
};

// A lattice of n_u x n_v x n_w zero displacements over [0,1]^3.
Lattice lattice_at_rest(const std::array<Knots, 3>& axes, const glm::dmat4& rest);

// The Greville abscissae (uvw) of a stored control point, by its indices along u, v and w.
glm::dvec3 greville(const Lattice& lattice, const glm::ivec3& index);

// The first function gives the world position of stored control point (i, j, k), the second one a
// lattice with control points at given world positions. Its `rest` is a translation to their mean,
// which keeps digits.
glm::dvec3 control_point(const Lattice& lattice, int i, int j, int k);
Lattice lattice_through(const Trivariate<glm::dvec3>& control_points_world);

// A PointMove is a stored control point, by its indices along u, v and w, and its movement.
struct PointMove {
    glm::ivec3 index{0};
    glm::dvec3 by{0}; // world
    bool operator==(const PointMove&) const = default;
};
// The lattice with control points moved; the others keep their bits. Indices must be inside.
Lattice moved(Lattice lattice, std::span<const PointMove> moves);

// The lattice after an affine map of the world.
Lattice mapped(Lattice lattice, const glm::dmat4& to_world);

// Parameters outside this interval lie before or after the domain of an open axis. There the
// displacement is that of the nearest end, so it does not change along this axis.
struct Reach {
    double least, most;
};
Reach reach(const Knots& knots);

// F, with F_u, F_v, F_w in `first` where derivatives >= 1. In double; the reference of deform().
Jet<glm::dvec3> evaluate(const Lattice& lattice, glm::dvec3 uvw, int derivatives = 0);

} // namespace trivar

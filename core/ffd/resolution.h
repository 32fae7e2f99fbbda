// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"

namespace trivar {

// These functions add control points where they are wanted, and remove them where they are not.
// Axes are 0, 1, 2.

// The new knots per axis, in any order.
using AxisKnots = std::array<std::vector<double>, 3>;

// The new knots with those that must go in with them: beside a twisted axis, their mirror images.
AxisKnots with_images(const Lattice& lattice, AxisKnots inserted);

// The same map with new knots and their images: exact but for rounding, which is at most 1e-12 of
// its size. Throws Rejected as with_inserted() does. O(#control points x order) per axis.
Lattice refined(const Lattice& lattice, const AxisKnots& inserted);

// The knots that refined() needs so that at least `across` control points along every axis lie in
// the sphere: middles of spans, halved again and again. Empty where enough lie there already. Where
// the sphere leaves the volume, its part inside counts; where its centre is outside, the nearest
// point is its centre. At most 2^8 parts per span. O(#control points).
AxisKnots knots_for_sphere(const Lattice& lattice, const glm::dvec3& center_world,
                           double radius_world, int across = 3);

// A CoarserLattice has fewer control points along one axis, with knots spread as the old ones are,
// and is the nearest such lattice by least squares. Clamped ends keep their layers. coarsened()
// throws Rejected unless order <= count < the axis's count. O(#control points x samples of an
// axis), with 4 samples per control point of the axis.
struct CoarserLattice {
    Lattice lattice;
    double deviation; // world; no point of the domain moves by more
};
CoarserLattice coarsened(const Lattice& lattice, int axis, int count);

// An upper bound of |F_a(uvw) - F_b(uvw)| over the domain, from their control points over the knots
// of both. Both lattices must have the same orders, closures, domains and rest maps.
double largest_difference(const Lattice& a, const Lattice& b);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"

namespace trivar {

// More control points where they are wanted, and fewer where they are not. Axes are 0, 1, 2.

// Further knots of one axis, in any order.
using AxisKnots = std::array<std::vector<double>, 3>;

// All that go in with those: beside a twisted axis, their mirror images too.
AxisKnots with_images(const Lattice& lattice, AxisKnots inserted);

// The same map with further knots, and their images: exact but for rounding, at most 1e-12 of its
// size. Throws Rejected as with_inserted() does.
// O(control points x order) an axis.
Lattice refined(const Lattice& lattice, const AxisKnots& inserted);

// The middles of spans, halved again and again, that refined() needs so that at least `across`
// control points along every axis lie in the sphere; empty where they do already. Where the sphere
// reaches out of the volume, in the part inside; where its centre is outside, round the nearest
// point. At most 2^8 parts a span. O(control points).
AxisKnots knots_for_sphere(const Lattice& lattice, const glm::dvec3& center_world,
                           double radius_world, int across = 3);

// An axis with fewer control points, their knots spread as the old ones are: what lies nearest by
// least squares. Clamped ends keep their layers. Throws Rejected unless order <= count < the
// axis's. O(control points x samples of an axis): 4 for each of its control points.
struct CoarserLattice {
    Lattice lattice;
    double deviation; // world; no point of the domain moves further
};
CoarserLattice coarsened(const Lattice& lattice, int axis, int count);

// An upper bound of |F_a(uvw) - F_b(uvw)| over the domain, by their control points over the knots
// of both. The lattices have the same orders, closures, domains and rest maps.
double largest_difference(const Lattice& a, const Lattice& b);

} // namespace trivar

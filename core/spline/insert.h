// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/tensor.h"

namespace trivar {

// The control points of the same spline over other knots of the same order: row j is the blossom
// of the piece over the first span of control point j, at the degree knots inside its support.
// `to` must repeat every knot of `from` inside its own domain at least as often, and its domain
// must lie inside that of `from`; then the map is exact, also at knots of full multiplicity.
// One map therefore serves insertion, sub-boxes, Bezier form and the opening of closed axes.
// O(count x order^2). Cohen, Lyche and Riesenfeld 1980 (Oslo algorithm 1); Ramshaw 1989.
AxisMap refinement_map(const Knots& from, const Knots& to);

// The knots with further ones, in any order. Throws Rejected where one lies outside the domain or
// its multiplicity would exceed the order (on a closed axis: where one would make it jump).
Knots with_inserted(const Knots& knots, std::span<const double> inserted);

// The same axis cut open: clamped at both ends of its domain, same breaks and multiplicities.
Knots opened(const Knots& knots);

// The spline over the knots `to` of one axis; see refinement_map.
template <class Spline> Spline over_knots(const Spline& f, int axis, const Knots& to)
{
    return mapped(f, axis, refinement_map(axis_of(f, axis), to), to);
}

// The same spline over finer knots of one axis (curves have axis 0 only). The shape is unchanged.
// insert_knots(c, 0, {{t}}) is Boehm's insertion of a single knot.
template <class Spline>
Spline insert_knots(const Spline& f, int axis, std::span<const double> inserted)
{
    return over_knots(f, axis, with_inserted(axis_of(f, axis), inserted));
}
template <class T> Curve<T> insert_knot(const Curve<T>& c, double t)
{
    return insert_knots(c, 0, std::span(&t, 1));
}

} // namespace trivar

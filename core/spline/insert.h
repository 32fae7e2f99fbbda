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

// Weights of control points s - degree .. s in the blossom, at `degree` arguments, of the piece
// over span s of knots t.
std::array<double, max_order> blossom(const std::vector<double>& t, int s, int degree,
                                      const double* arguments);

// The knots with additional ones, in any order. Throws Rejected where one lies outside the domain
// or its multiplicity would exceed the order (on a closed axis: where one would make it jump).
Knots with_inserted(const Knots& knots, std::span<const double> inserted);

// The same axis cut open: clamped at both ends of its domain, same breaks and multiplicities.
Knots opened(const Knots& knots);

// The spline over the knots `to` of one axis (curves have axis 0 only); see refinement_map. Throws
// Rejected where a twisted axis could not mirror the new knots: opened_twists() first.
template <class Spline> Spline over_knots(const Spline& f, int axis, const Knots& to)
{
    Spline out = mapped(f, axis, refinement_map(axis_of(f, axis), to), to);
    check_shape(out);
    return out;
}

// The same spline with its twisted axes cut open, but for the named one. Work that treats both
// halves of a mirrored axis differently starts here.
template <class Spline> Spline opened_twists(Spline f, int except = -1)
{
    for (int axis = 0; axis < static_cast<int>(axes_of(f).size()); ++axis)
        if (axis != except && axis_of(f, axis).closure() == Closure::twisted)
            f = over_knots(f, axis, opened(axis_of(f, axis)));
    return f;
}

// The same shape over finer knots of one axis.
template <class Spline>
Spline insert_knots(const Spline& f, int axis, std::span<const double> inserted)
{
    return over_knots(f, axis, with_inserted(axis_of(f, axis), inserted));
}

} // namespace trivar

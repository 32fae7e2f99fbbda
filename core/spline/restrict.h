// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/insert.h"

namespace trivar {

// Clamped knots over [lo, hi] that repeat those of the axis inside it. At lo counts what lies right
// of it and at hi what lies left of it, so that a knot of full multiplicity may be an end. Throws
// Rejected unless begin <= lo < hi <= end.
Knots restricted(const Knots& knots, double lo, double hi);

// The part of a spline over [lo, hi] of one axis, with the parameters it had. A restricted axis
// is open; so are twisted ones beside it.
template <class Spline> Spline restricted(const Spline& f, int axis, double lo, double hi)
{
    return over_knots(opened_twists(f, axis), axis, restricted(axis_of(f, axis), lo, hi));
}

// The part of a volume over the box [lo, hi].
template <class T>
Trivariate<T> restricted(const Trivariate<T>& f, const glm::dvec3& lo, const glm::dvec3& hi)
{
    Trivariate<T> out = opened_twists(f);
    for (int axis = 0; axis < 3; ++axis) out = restricted(out, axis, lo[axis], hi[axis]);
    return out;
}

} // namespace trivar

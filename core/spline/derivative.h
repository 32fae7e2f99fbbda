// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/insert.h"

namespace trivar {

// The knots of the derivative and its control points
// P'_i = d (P_{i+1} - P_i) / (t_{i+o} - t_{i+1}). The order falls by one, but not below 2: there
// the derivative is constant between knots, which is a line with a jump at each of them. Points
// that no span uses are dropped. de Boor 1978.
struct DerivativeNet {
    Knots knots;
    AxisMap map;
};
DerivativeNet derivative_net(const Knots& knots);

// The derivative of a spline along one axis, as a spline over the same domain. Its control points
// bound it: the values lie in their convex hull. A twisted axis beside it is cut open, for the
// derivative changes sign where it mirrors.
template <class Spline> Spline derivative(const Spline& f, int axis)
{
    const DerivativeNet net = derivative_net(axis_of(f, axis));
    return mapped(opened_twists(f, axis), axis, net.map, net.knots);
}

} // namespace trivar

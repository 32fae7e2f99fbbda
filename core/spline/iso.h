// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/insert.h"

namespace trivar {

// The points of a tensor product with one axis contracted at t, brought into the domain. An odd
// turn of a twisted axis mirrors all other axes, which reverses the order of the points.
template <class T>
std::vector<T> contracted(std::span<const Knots> axes, std::span<const T> points, int axis,
                          double t)
{
    const Knots& knots = axes[static_cast<std::size_t>(axis)];
    return applied(sampling_map(knots, std::span(&t, 1)), extent(knots), points,
                   points_inside(axes, axis));
}

// The curve on a surface where the parameter of `axis` is t: its control points are
// sum_k N_k(t) P_k. O(points). A twisted axis that remains is cut open, for its mirror image of
// this curve is another one.
template <class T> Curve<T> iso_curve(const Surface<T>& s, int axis, double t)
{
    const Surface<T> f = opened_twists(s, axis);
    return {f.axes[axis == 0 ? 1 : 0],
            contracted(axes_of(f), std::span<const T>(f.points), axis, t)};
}

// The surface in a volume where the parameter of `axis` is t; its axes are the other two in their
// order. The face of a clamped axis is the iso-surface at its begin or end.
template <class T> Surface<T> iso_surface(const Trivariate<T>& volume, int axis, double t)
{
    const Trivariate<T> f = opened_twists(volume, axis);
    return {{f.axes[axis == 0 ? 1 : 0], f.axes[axis == 2 ? 1 : 2]},
            contracted(axes_of(f), std::span<const T>(f.points), axis, t)};
}

} // namespace trivar

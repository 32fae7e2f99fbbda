// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/axis_map.h"
#include "core/spline/curve.h"
#include "core/spline/surface.h"
#include "core/spline/trivariate.h"

namespace trivar {

// These functions are common to curves, surfaces and trivariate functions, so that an algorithm
// along one axis is written once.

template <class T> std::span<const Knots> axes_of(const Curve<T>& f)
{
    return {&f.knots, 1};
}
template <class T> std::span<const Knots> axes_of(const Surface<T>& f)
{
    return f.axes;
}
template <class T> std::span<const Knots> axes_of(const Trivariate<T>& f)
{
    return f.axes;
}

template <class Spline> const Knots& axis_of(const Spline& f, int axis)
{
    return axes_of(f)[static_cast<std::size_t>(axis)];
}

template <class T> void replace_axis(Curve<T>& f, int, const Knots& knots)
{
    f.knots = knots;
}
template <class T> void replace_axis(Surface<T>& f, int axis, const Knots& knots)
{
    f.axes[static_cast<std::size_t>(axis)] = knots;
}
template <class T> void replace_axis(Trivariate<T>& f, int axis, const Knots& knots)
{
    f.axes[static_cast<std::size_t>(axis)] = knots;
}

// The number of stored points that vary faster than the axis.
inline std::size_t points_inside(std::span<const Knots> axes, int axis)
{
    std::size_t inner = 1;
    for (const Knots& k : axes.subspan(static_cast<std::size_t>(axis) + 1))
        inner *= static_cast<std::size_t>(k.count());
    return inner;
}

// Throws Rejected unless the number of points fits the axes and twisted axes can mirror: all other
// axes are then open and their knots symmetric.
void check_shape(std::span<const Knots> axes, std::size_t points);
template <class Spline> void check_shape(const Spline& f)
{
    check_shape(axes_of(f), f.points.size());
}

// The spline whose points along one axis are the map's rows, over the knots `to`.
template <class Spline>
Spline mapped(const Spline& f, int axis, const AxisMap& map, const Knots& to)
{
    using T = typename decltype(f.points)::value_type;
    Spline out = f;
    out.points = applied(map, extent(axis_of(f, axis)), std::span<const T>(f.points),
                         points_inside(axes_of(f), axis));
    replace_axis(out, axis, to);
    return out;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/insert.h"

namespace trivar {

// The axis cut open with every interior knot repeated order - 1 times (order times where it was
// cut): the control points of each span are then those of a Bezier cell.
Knots bezier_knots(const Knots& knots);

// A BezierSpan is the place of a cell of such an axis and the first of its `order` control points.
struct BezierSpan {
    double lo, hi;
    int first;
};
std::vector<BezierSpan> bezier_spans(const Knots& bezier);

// The same shape in Bezier form along every axis.
template <class Spline> Spline bezier_form(Spline f)
{
    f = opened_twists(std::move(f));
    for (int axis = 0; axis < static_cast<int>(axes_of(f).size()); ++axis)
        f = over_knots(f, axis, bezier_knots(axis_of(f, axis)));
    return f;
}

// The rows of the square matrix that turns the control points of a Bezier polynomial over [0, 1]
// into those of the same polynomial over [lo, hi], order x order, row-major: coefficient i is the
// blossom at (lo^(d-i), hi^i). No allocation.
std::array<double, max_order * max_order> bezier_segment(int order, double lo, double hi);

} // namespace trivar

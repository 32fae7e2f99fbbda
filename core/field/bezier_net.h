// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/row4.h"

#include <array>
#include <glm/glm.hpp>

namespace trivar {

// A BezierNet is a polynomial of degree 3 in x, y and z over a box, by its 4 x 4 x 4 Bezier
// coefficients: row y + 4 z holds those along x. The polynomial is in their hull.
struct BezierNet {
    std::array<Row4<float>, 16> rows;

    // Whether 0 is in the hull, widened by a margin on both sides.
    bool may_vanish(float margin) const;
};

// The net of one cell of a cubic B-spline, from its 4 x 4 x 4 coefficients in the same order.
void make_bezier(BezierNet& net);

// Returns the net of <p + from, grad f> for p in the unit cube of a cell, or of <from, grad f> for
// a parallel view.
//   f     the net of the cell
//   from  the lower corner of the cell minus the eye, or the direction of sight; voxels
// The derivatives are raised to degree 3 in each variable; p_x f_x is of degree 3 in x, too.
enum class Sight { parallel, from_eye };
BezierNet sight_net(const BezierNet& f, const glm::vec3& from, Sight sight);

// Both halves along an axis, 0 to 2, by de Casteljau's algorithm.
void halve(const BezierNet& net, int axis, BezierNet& lower, BezierNet& upper);

} // namespace trivar

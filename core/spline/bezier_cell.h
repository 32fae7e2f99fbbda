// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/spline/bezier.h"

#include <glm/glm.hpp>

namespace trivar {

// A BezierCell is one polynomial piece of a trivariate map, in Bernstein form over the box [lo,
// hi].
struct BezierCell {
    glm::ivec3 orders{0};
    glm::dvec3 lo{0}, hi{1};        // uvw
    std::vector<glm::dvec3> points; // order_u x order_v x order_w, w fastest
};

// The pieces of a map, the last axis fastest. Closed axes are cut open.
std::vector<BezierCell> bezier_cells(const Trivariate<glm::dvec3>& f);

// The first function gives the same polynomial over the local box [lo, hi]; the second the box
// round the control points, which holds the piece (convex hull).
BezierCell part_of(const BezierCell& cell, const glm::dvec3& lo, const glm::dvec3& hi);
Box bounds(const BezierCell& cell);

} // namespace trivar

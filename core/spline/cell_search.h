// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/bezier_cell.h"

namespace trivar {

// A local minimum of |F(x) - p| over the cell's box of local parameters.
struct CellSearch {
    glm::dvec3 x{0};
    double residual = 0;  // |F(x) - p|
    bool settled = false; // at a minimum: no direction inside the box leads nearer
};

// Levenberg and Marquardt's descent from x, projected into [0, 1]^3; with a regular Jacobian and p
// inside it is Newton's method, which settles in 3 to 6 steps. `enough` is the residual below
// which it need not go on. At most 60 steps.
CellSearch search_cell(const BezierCell& cell, const glm::dvec3& p, glm::dvec3 x, double enough);

} // namespace trivar

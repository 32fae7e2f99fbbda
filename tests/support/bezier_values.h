// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/index.h"
#include "core/spline/bezier_cell.h"

#include <array>

namespace trivar::testing {

// Computes the Bernstein polynomials of one order at x, and their derivatives.
struct Bernstein {
    std::array<double, max_order> value{1}, derivative{};
};
inline Bernstein bernstein(int order, double x)
{
    Bernstein b;
    for (int p = 1; p < order; ++p) {
        if (p == order - 1)
            for (int r = 0; r <= p; ++r)
                b.derivative[at(r)] =
                    p * ((r > 0 ? b.value[at(r - 1)] : 0) - (r < p ? b.value[at(r)] : 0));
        for (int r = p; r >= 0; --r)
            b.value[at(r)] =
                (r < p ? b.value[at(r)] * (1 - x) : 0) + (r > 0 ? b.value[at(r - 1)] * x : 0);
    }
    return b;
}

// The value and Jacobian [F_x F_y F_z] of a cell at local parameters x in [0, 1]^3, straight from
// the definition. O(order^3), no allocation.
struct CellValue {
    glm::dvec3 value{0};
    glm::dmat3 jacobian{0};
};
inline CellValue cell_value(const BezierCell& cell, const glm::dvec3& x)
{
    const Bernstein u = bernstein(cell.orders.x, x.x), v = bernstein(cell.orders.y, x.y),
                    w = bernstein(cell.orders.z, x.z);
    CellValue out;
    const glm::dvec3* p = cell.points.data();
    for (int i = 0; i < cell.orders.x; ++i) {
        // Contracts over w, then over v: the value of the plane and its slopes along v and w.
        glm::dvec3 plane(0), plane_v(0), plane_w(0);
        for (int j = 0; j < cell.orders.y; ++j) {
            glm::dvec3 line(0), line_w(0);
            for (int k = 0; k < cell.orders.z; ++k, ++p) {
                line += *p * w.value[at(k)];
                line_w += *p * w.derivative[at(k)];
            }
            plane += line * v.value[at(j)];
            plane_v += line * v.derivative[at(j)];
            plane_w += line_w * v.value[at(j)];
        }
        out.value += plane * u.value[at(i)];
        out.jacobian[0] += plane * u.derivative[at(i)];
        out.jacobian[1] += plane_v * u.value[at(i)];
        out.jacobian[2] += plane_w * u.value[at(i)];
    }
    return out;
}

} // namespace trivar::testing

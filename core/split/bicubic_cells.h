// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

namespace trivar {

// BicubicCells is an open bicubic spline with equally spaced knots, ready to be evaluated many
// times: the polynomial of each cell in powers of its local parameters. About 10 nanoseconds a
// value, and 20 with derivatives. Parameters beyond the domain are moved to its border.
class BicubicCells {
public:
    BicubicCells() = default;
    explicit BicubicCells(const Surface<double>& surface);

    struct Jet {
        double value = 0, u = 0, v = 0;
    };
    double value(const glm::dvec2& uv) const;
    Jet jet(const glm::dvec2& uv) const;

private:
    struct Local { // where a parameter pair is
        const double* cell;
        double x, y; // 0..1
    };
    Local local(const glm::dvec2& uv) const;

    glm::dvec2 begin_{0}, per_cell_{1}; // per_cell_: 1 / length of a cell
    glm::ivec2 count_{0};
    std::vector<double> powers_; // 16 a cell, powers of u fastest
};

} // namespace trivar

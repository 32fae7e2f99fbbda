// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <cstdint>

namespace trivar {

// AxisCells divides one axis of a lattice into cells: its non-empty spans, and one more cell at
// each end for parameters beyond the domain. In a cell a spline is a polynomial in t, which goes
// from -1/2 to 1/2 over the cell: centred, so that powers lose no digits in single precision.
class AxisCells {
public:
    explicit AxisCells(const Knots& knots);

    // The cell of u, and the place in it; on a closed axis u is first brought into the domain. If u
    // is not a number, any cell.
    struct Place {
        std::uint32_t cell;
        float t;
    };
    Place place(double u) const;

    std::uint32_t count() const { return static_cast<std::uint32_t>(cells_.size()); }

    struct Cell {
        int first = 0;       // unwrapped control point of the first basis function
        double center = 0;   // t = (u - center) * per_unit
        double per_unit = 0; // dt/du; 0 beyond the ends
        // Coefficient of t^m in basis function `first + r`, at [m][r].
        std::array<std::array<double, max_order>, max_order> power{};
    };
    const Cell& operator[](std::uint32_t cell) const { return cells_[cell]; }

private:
    std::vector<double> breaks_;
    double spans_per_unit_;
    double least_, most_; // parameters outside of these lie in the cells at the ends
    std::vector<Cell> cells_;
};

} // namespace trivar

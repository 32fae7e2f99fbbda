// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/knots.h"

#include <cstdint>

namespace trivar {

// One axis of a lattice as cells: its non-empty spans, and one more at each end for what lies
// beyond. In a cell a spline is a polynomial in t, which goes from -1/2 to 1/2 over the cell:
// centred, so that powers lose no digits in single precision.
class AxisCells {
public:
    explicit AxisCells(const Knots& knots);

    // Where u, brought into the domain if the axis is closed, lies. Not a number: in some cell.
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
    double least_, most_; // beyond these a parameter lies in the cells at the ends
    std::vector<Cell> cells_;
};

} // namespace trivar

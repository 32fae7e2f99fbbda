// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/bernstein.h"
#include "core/ffd/lattice.h"

#include <functional>

namespace trivar {

// A CellGrid numbers the cells of a lattice, with w fastest. Cells lie between its distinct knots;
// closed axes are cut open at the ends of the domain.
class CellGrid {
public:
    explicit CellGrid(const std::array<Knots, 3>& axes);

    glm::ivec3 size() const; // cells along u, v and w
    std::size_t count() const;
    std::array<std::vector<double>, 3> breaks() const; // ascending, one more than there are cells

    struct Place {
        glm::dvec3 lo, hi; // uvw
    };
    Place place(std::size_t cell) const;

    // The cells whose shape depends on the moved control points, ascending.
    std::vector<int> touched(std::span<const PointMove> moves) const;

    // A Span is one cell along an axis.
    struct Span {
        double lo, hi;
        int first; // unwrapped control point of the first basis function
        // Row i: the weights of the control points in the Bezier point i of the span.
        std::array<double, max_order * max_order> bezier;
    };
    std::array<const Span*, 3> spans(std::size_t cell) const;

private:
    std::array<Knots, 3> axes_;
    std::array<std::vector<Span>, 3> spans_;
};

// A CellDeterminant is det J of the map uvw -> world in one cell, of degree 3d - 1 along an axis of
// degree d.
struct CellDeterminant {
    Bernstein f;
    double least = 0, most = 0; // of the coefficients
    double mean = 0;            // over the cell; not finite where a coefficient is not
    double doubt = 0;           // the largest rounding error of a coefficient
};

// Calls body(which, determinant) for cells[which], in any order and on any thread; the determinant
// lives only during the call. Cost: 5 microseconds per tri-cubic cell; two or four are computed at
// a time, without allocation. The same bits on every machine. `grid` must be that of the lattice's
// axes.
void each_determinant(const CellGrid& grid, const Lattice& lattice, std::span<const int> cells,
                      const std::function<void(std::size_t which, const CellDeterminant&)>& body);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/sorted_vertices.h"
#include "core/spline/trivariate.h"

#include <span>

namespace trivar {

// CellPolynomials holds the displacement in every occupied cell as a polynomial in the cell's t, in
// single precision, with the matrices for the chain rule.
struct CellPolynomials {
    std::array<int, 3> order{};
    // Per cell order_u x order_v x order_w x 4 coefficients, highest powers first, as Horner's rule
    // takes them; x, y, z and a zero. The NEGATED displacement: rest - (+0) has the bits of rest
    // even where rest is -0, while rest + 0 does not.
    std::vector<float> coefficients;
    struct Frame {
        // The Jacobian is J = rest - (d polynomial / dt) * t_by_p. Both matrices are scaled by a
        // power of two so that products neither overflow nor underflow. Rows of t_by_p belong to t,
        // rows of rest to the world.
        std::array<std::array<float, 3>, 3> t_by_p{}, rest{};
        bool still = false; // J is the identity: normals and tangents stay as they are
    };
    std::vector<Frame> frames;

    std::size_t stride() const
    {
        return static_cast<std::size_t>(order[0] * order[1] * order[2]) * 4;
    }
};

// Computes the polynomials of some cells.
//   displacement  of the lattice, world units
//   axes          cells along u, v and w
//   cells         the occupied cells, in the order of the result
//   embedding     object space to uvw, and to the world at rest
// Cost: about 800 multiplications of four doubles per cell of a tri-cubic lattice, as much as the
// deformation of some ten vertices.
CellPolynomials cell_polynomials(const Trivariate<glm::dvec3>& displacement,
                                 const std::array<AxisCells, 3>& axes,
                                 std::span<const SortedVertices::CellKey> cells,
                                 const Embedding& embedding);

} // namespace trivar

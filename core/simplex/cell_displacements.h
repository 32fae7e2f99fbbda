// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_basis.h"

#include <span>

namespace trivar {

// Displacements in each cell of a domain as a polynomial of a degree from 1 to 3, by its values at
// the nodes of CellInterpolation: for each cell in turn 4, 10 or 20 of them. They hold for any
// clouds of knots and any cuts in the domain.
using CellDisplacements = std::vector<glm::dvec3>;

// The degree of values for so many cells; 0: they are none for so many.
int degree_of(std::size_t values, std::size_t cells);

// Returns the displacements of control points whose spline is the polynomials: polar forms at the
// knots of their functions. Functions of several cells that share a control point get the mean.
// Exact where the polynomials have the continuity of the spline.
//   values  at the nodes of CellInterpolation, cell by cell; of a degree of at most the basis's
// About 10 us per cell for degree 3; the same bits for any number of threads.
std::vector<glm::dvec3> control_displacements(const SimplexBasis<3>& basis,
                                              std::span<const glm::dvec3> values);

} // namespace trivar

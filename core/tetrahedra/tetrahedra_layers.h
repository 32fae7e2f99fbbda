// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/simplex_basis.h"
#include "core/tetrahedra/tetrahedra_shape.h"

namespace trivar {

// The greatest number of cells of a layer.
inline constexpr std::size_t most_cells = 200000;
// The greatest number of cells of the domain and all refinements together.
inline constexpr std::size_t most_cells_in_all = 2 * most_cells;

// The vertices and cells of the domain, without knots.
SimplexMesh<3> domain_cells(const TetrahedraShape& shape);

// The tetrahedra with that edge length of a grid whose middles are within the radius of one of the
// places. Throws Rejected where they are none or more than most_cells.
SimplexMesh<3> cells_near(const TetrahedraRefinement& refinement);

// Returns the domain with its creases and clouds. Throws Rejected for domains that check() refuses.
SimplexDomain<3> domain_of(const TetrahedraShape& shape);

// Returns that domain, and one layer per refinement, whose functions fade smoothly at its border.
// Throws Rejected for what check() refuses, and for degrees and sizes out of range.
std::vector<Ref<SimplexBasis<3>>> layers_of(const TetrahedraShape& shape);

// The size of the box about the origin that holds the domain: that of its warps.
glm::dvec3 size_of(const TetrahedraShape& shape);

} // namespace trivar

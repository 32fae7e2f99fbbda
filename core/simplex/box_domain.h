// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

namespace trivar {

// The vertices and cells of a domain, before it has knots.
template <int S> struct SimplexMesh {
    std::vector<glm::vec<S, double>> vertices;
    std::vector<std::array<int, S + 1>> cells; // of positive orientation
    bool operator==(const SimplexMesh&) const = default;
};

// A box about the origin in that many boxes along each axis (1..100), each in 6 tetrahedra round
// its diagonal [Freudenthal, 1942]. Their faces fit. Vertices are numbered as boxes are, the last
// axis fastest.
SimplexMesh<3> box_cells(const glm::dvec3& size, const glm::ivec3& boxes);
// A rectangle in 2 triangles per box.
SimplexMesh<2> rectangle_cells(const glm::dvec2& size, const glm::ivec2& boxes);

} // namespace trivar

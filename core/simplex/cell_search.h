// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/box_grid.h"
#include "core/simplex/simplex_mesh.h"

namespace trivar {

// A CellSearch finds the cell in which a point lies.
class CellSearch {
public:
    explicit CellSearch(SimplexMesh<3> mesh);
    // The first cell that holds the point, or is nearer to it than 1e-12 of its own size; -1: none.
    int cell_at(const glm::dvec3& x) const;

private:
    SimplexMesh<3> mesh_;
    BoxGrid<3> grid_;
};

} // namespace trivar

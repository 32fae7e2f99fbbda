// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/cells_around.h"

namespace trivar {

// Cells that hold the convex hull of some points, with the margin and border of cells_around().
// Points in one plane or line have a hull as thin as that. Throws Rejected as cells_around() does.
// The hull costs about 1 us per point.
FilledCells hull_cells(std::span<const glm::dvec3> points, const CellFilling& filling);

} // namespace trivar

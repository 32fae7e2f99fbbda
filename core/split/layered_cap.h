// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/plane_grid.h"
#include "core/split/cap_options.h"
#include "core/split/flat_cap.h"
#include "core/split/rim_loops.h"

namespace trivar {

// The grid on which loops are cut: over all of their places.
PlaneGrid grid_of(const std::vector<const RimLoop*>& loops, const std::vector<glm::dvec2>& places);

// Closes loops that cross: an area that they run round n times is covered by n layers of triangles,
// reversed where they run clockwise, each with points of its own; slivers lead from the edges of
// the rim to their ways through the layers. So it is closed whatever the loops are, and covers
// nothing that they do not run round. Returns false, with nothing added, if the crossings have no
// end on the grid. O(n^2).
bool close_in_layers(const std::vector<const RimLoop*>& loops, const CapOptions& options,
                     FlatCap& cap);

} // namespace trivar

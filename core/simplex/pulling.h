// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_volume.h"
#include "core/simplex/tetrahedra_shape.h"

namespace trivar {

// The change of the displacements of all layers by a pull, before a guard holds it. A control point
// takes the share of the movement that decay() gives for the distance of its rest from the middle
// of the ball. Those of a refinement also fade to 0 at one edge before its rim, from 0.3 of
// that distance on. `refinement` is the one of the pull's layer; null: the domain. O(number of
// control points times number of places).
std::vector<glm::dvec3> change_by(const TetrahedraPull& pull, const SimplexVolume& volume,
                                  const TetrahedraRefinement* refinement = nullptr);

// The control points of a layer that a ball reaches: those of the cells that touch it and are
// connected within it, but for faces that are cut, with the cell that is nearest to its middle. All
// points where nothing is cut. By point, O(number of cells).
std::vector<bool> reached(const SimplexBasis<3>& layer, const glm::dvec3& middle, double radius);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_volume.h"
#include "core/tetrahedra/tetrahedra_shape.h"

namespace trivar {

// Returns the change of the displacements of all layers by a pull, before a guard holds it. A
// control point takes the share of the movement that decay() gives for the distance of its rest
// from the nearest middle of a ball that reaches it. Those of a refinement also fade to 0 at one
// edge before its rim, from 0.3 of that distance on.
//   refinement  that of the pull's layer; null: the domain
// O(number of control points times number of places and balls).
std::vector<glm::dvec3> change_by(const TetrahedraPull& pull, const SimplexVolume& volume,
                                  const TetrahedraRefinement* refinement = nullptr);

// Returns the current position of a control point of a layer; for a refinement, its rest position.
// `point` counts from the first one of the layer.
glm::dvec3 place_of(const SimplexVolume& volume, std::size_t layer, std::size_t point);

// The share, 0..1, that a control point of a refinement takes by where it rests: 0 at the rim.
double share_inside(const TetrahedraRefinement& refinement, const glm::dvec3& rest);

// The middles of a pull's balls.
std::vector<glm::dvec3> middles(const TetrahedraPull& pull);

// Returns, by point, which control points of a layer a ball reaches: those of the cells that touch
// it and are connected within it, across uncut faces, with the cell that holds its middle; all
// points if nothing is cut. O(number of cells).
std::vector<bool> reached(const SimplexBasis<3>& layer, const glm::dvec3& middle, double radius);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tetrahedra/pulling.h"

namespace trivar {

// A ControlPlace groups the control points that a user moves as one: same rest position and knots,
// cells connected across uncut faces.
struct ControlPlace {
    glm::dvec3 rest{0};
    // Unit, from there into one of the cells; 0 where no cut parts it from another place.
    glm::dvec3 inward{0};
    double spacing = 0;      // distance of the nearest other place of the same cells
    std::vector<int> points; // numbers of control points of the layer, ascending
    std::vector<int> cells;  // of their functions, ascending
};

// All of a layer, in order of the vertices that they belong to. O(n log n) for n functions.
std::vector<ControlPlace> control_places(const SimplexBasis<3>& layer);

// Returns a pull that moves just the control points at some places, by nothing as yet.
//   chosen  numbers of places, at least one
//   radius  of its balls; 0: they hold no other places
// O(number of places times number of chosen ones).
TetrahedraPull pull_of(const std::vector<ControlPlace>& places, const std::vector<int>& chosen,
                       double radius = 0);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/surface_distance.h"
#include "core/simplex/simplex_mesh.h"

#include <span>

namespace trivar {

// A BorderFit says where the border of some cells of a mesh wants to be.
struct BorderFit {
    const SurfaceDistance& surface;
    std::span<const double> distance; // of each vertex from the surface
    double least_angle;               // radians between faces of a chosen cell
};

// The mesh with the vertices on the border of the chosen cells moved to their distances, or part
// of the way where a chosen cell would get a lesser angle or any cell would turn over. Pinned
// vertices (a flag for each) stay. In order of their numbers, 4 times over: about 20 us per vertex
// of the border.
SimplexMesh<3> with_fitted_border(SimplexMesh<3> mesh, const std::vector<bool>& chosen,
                                  const std::vector<bool>& pinned, const BorderFit& fit);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/tangent.h"
#include "core/tiles/tile_base.h"

namespace trivar {

// A SurfaceRay is where a straight way over the surface has come to.
struct SurfaceRay {
    SurfacePlace at;
    glm::dvec3 direction{
        0};          // unit, in the plane of the triangle; zero where there was no way to go
    double left = 0; // length that a border cut off
};

// Follows the straightest way from a place: straight in each triangle, and over each edge as if
// both triangles were unfolded (Polthier and Schmies, "Straightest geodesics on polyhedral
// surfaces", 1998). It stops at borders.
//   way  in the plane of the normal at `start`; its length is the way's
// O(#edges crossed), at most 100,000 of them.
SurfaceRay straightest(const TileBase& base, const SurfacePlace& start, const glm::dvec3& way);

} // namespace trivar

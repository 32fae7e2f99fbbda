// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cut_surface.h"

namespace trivar {

// A WallCertificate states proven facts of a wall below (side 0) or above (1) a cut surface.
struct WallCertificate {
    double clear = 0; // metres: nowhere is the obstacle nearer along u; negative: not certain
    // Points of the obstacle, in uvw, at which the wall is nearer than wanted.
    std::vector<glm::dvec3> too_near;
};

// Bounds the distance of a wall from the flat triangles of the obstacle: it is what it is at the
// corners less how far wall and cut surface bend between them, by the Bezier nets of both;
// triangles for which that does not suffice are halved, up to some thousand times.
//   side    0 below, 1 above the cut surface
//   wanted  metres, at which the search ends
// About 0.2 us a triangle, in parallel.
WallCertificate certificate(const ObstacleColumns& obstacle, const CutSurface& surface,
                            const Surface<double>& wall, std::size_t side, double wanted);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/pressing.h"

namespace trivar {

// Returns the place to which a warp moves a point of a box about the origin.
//   p     metres, along the box's own X, Y and Z
//   size  metres, above 0
glm::dvec3 warped(const glm::dvec3& p, const glm::dvec3& size, const Warp& warp);

// A share of a warp: every amount times `share`.
Warp part_of(Warp warp, double share);

// A WarpedVolume is a volume after a warp, and the share of the warp that was done: where guarded,
// the largest of 64 shares that is proven not to fold. warped() throws Rejected where the volume
// was no box when it was laid. O(#control points), and judges the volume up to seven times.
struct WarpedVolume {
    LaidVolume volume;
    double share = 1;
    double moved = 0; // longest way of any control point, metres
};
WarpedVolume warped(const LaidVolume& volume, const Warp& warp);

} // namespace trivar

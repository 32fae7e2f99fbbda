// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// Makes strokes of silhouettes in an image. `to_image` maps voxels to pixels and depth,
// homogeneous. A stroke ends where another line passes before it or where it has a cusp, and not at
// the last point that is seen; ends that face each other are joined, nearest first, since each fold
// of a rough surface ends a line a hair away from the one that goes on; the points are joined by
// Catmull-Rom curves. O(n log n).
std::vector<Stroke> strokes(const Silhouettes& silhouettes, const std::vector<char>& hidden,
                            const glm::dmat4& to_image, const StrokeOptions& options = {});

} // namespace trivar

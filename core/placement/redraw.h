// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// These functions change a stroke that was drawn before. Pixels are those of the sketch's own
// picture.

// Returns the samples of another view as if they had been drawn in the sketch's view: the places at
// which their rays meet the scene, or pass at the depth of the last meeting. Equal views change
// nothing. Empty if no ray meets the scene.
std::vector<StrokeSample> seen_from(const Camera& sketch, const Camera& drawn_in,
                                    const std::vector<StrokeSample>& samples,
                                    const RayScene& scene);

// The share of the stroke's length at which it comes nearest to a point, and the distance there.
struct NearestShare {
    double share = 0, distance_px = 0;
};
NearestShare nearest_share(const Sketch& sketch, glm::dvec2 p_px);
double length_px(const std::vector<StrokeSample>& samples);

// Returns the stroke with a piece drawn anew. The new piece leaves the old stroke at the sample
// nearest to its beginning. A piece that ends within `near_px` of the stroke replaces the part
// between; any other replaces the rest, on the side toward which it sets out. All other samples
// stay as they are; times continue without a break.
Sketch redrawn(const Sketch& sketch, const std::vector<StrokeSample>& piece, double near_px);

// Bends the stroke by a pull at one place. That place moves by the whole way, its neighbours on
// both sides by less and less. A ring is bent across its seam too.
//   share  the place, a share of the stroke's length
//   reach  samples further than this share of the length do not move
Sketch bent(const Sketch& sketch, double share, glm::dvec2 by_px, double reach);

} // namespace trivar

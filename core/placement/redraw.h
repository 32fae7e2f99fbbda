// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// Changes of a stroke that was drawn before. Pixels are those of the sketch's own picture.

// Samples drawn in another view, as if drawn in the sketch's: where their rays meet the scene, or
// go by at the depth they met it last, is seen from there. Equal views change nothing. Empty where
// no ray meets the scene.
std::vector<StrokeSample> seen_from(const Camera& sketch, const Camera& drawn_in,
                                    const std::vector<StrokeSample>& samples,
                                    const RayScene& scene);

// Where on the stroke, as a share of its length, it comes nearest to a point, and how near.
struct NearestShare {
    double share = 0, distance_px = 0;
};
NearestShare nearest_share(const Sketch& sketch, glm::dvec2 p_px);
double length_px(const std::vector<StrokeSample>& samples);

// The stroke with a piece drawn anew. It leaves the old stroke at the sample nearest to where the
// piece begins. A piece that ends within `near_px` of the stroke replaces what is between; any
// other replaces the rest, on the side it sets out to. All other samples stay as they are; times
// go on without a break.
Sketch redrawn(const Sketch& sketch, const std::vector<StrokeSample>& piece, double near_px);

// The stroke pulled at one place: it goes there by the whole way, to both sides ever less, and from
// `reach` (a share of the length) on not at all. A ring is bent across its seam too.
Sketch bent(const Sketch& sketch, double share, glm::dvec2 by_px, double reach);

} // namespace trivar

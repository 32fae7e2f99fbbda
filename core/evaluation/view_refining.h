// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/evaluation/evaluate.h"

namespace trivar {

// The largest distance in world units of a flat triangle inside a box from the true surface that
// keeps every point in the picture within `tolerance_px` of its place. With f pixels per unit at
// depth 1, p at depth z and at an angle a from the middle of the picture, and |q - p| <= t:
//
//   |q' - p'| <= f t / (cos a (z - t)),   so   t = px z / (f / cos a + px),
//
// z is the least depth in the box and a the angle of the picture's corners. The result is rounded
// down to a power of the square root of 2, so that a camera that hardly moves changes nothing. It
// is infinite where no part of the box is in the picture. Points nearer than a hundredth of the
// box's diagonal get no promise.
double view_tolerance(const Camera& camera, const Box& bounds, double tolerance_px);

// SeenEffects holds the effects of a document as one camera wants to see them: parts in volumes are
// split until each triangle is proven to be seen within some pixels of the true surface. Neither
// the document nor other results change.
struct SeenEffects {
    Evaluation evaluated;
    std::size_t triangles = 0; // of the parts in volumes
    std::size_t open = 0; // of those, the number that is not proven because the budget is spent
};

// ViewRefining refines effects one after another and keeps the last few results for each object.
class ViewRefining {
public:
    // The budget of triangles is shared evenly by the parts in volumes; no part gets fewer
    // triangles than it already has. Cost: about 8 us per new triangle, nothing for a result that
    // is kept.
    SeenEffects operator()(const Evaluation& evaluated, const Camera& camera, double tolerance_px,
                           const Progress& progress = {}, std::size_t budget = 400'000);

private:
    struct KnownView {
        Ref<EvaluatedObject> object;
        double tolerance = 0;
        std::size_t budget = 0;
        Ref<EvaluatedObject> seen;
    };
    std::vector<KnownView> known_; // the latest first
};

} // namespace trivar

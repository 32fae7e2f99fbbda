// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/evaluation/evaluate.h"

namespace trivar {

// How far a flat triangle inside a box may be from the true surface, in world units, so that in the
// picture no point is further than some pixels from where it should be. With f pixels a unit at
// depth 1, p at depth z and at an angle a from the middle of the picture, and |q - p| <= t:
//
//   |q' - p'| <= f t / (cos a (z - t)),   so   t = px z / (f / cos a + px),
//
// z the least depth in the box and a that of the picture's corners. Rounded down to a power of the
// square root of 2, so that a camera that hardly moves changes nothing; infinite where nothing of
// the box is in the picture. What is nearer than a hundredth of the box's diagonal is promised
// nothing.
double view_tolerance(const Camera& camera, const Box& bounds, double tolerance_px);

// The effects of a document as one camera wants to see them: what lies in volumes is split until
// each triangle is proven to be seen within some pixels of the true surface. The document, and what
// is made of its effects elsewhere, know nothing of it.
struct SeenEffects {
    Evaluation evaluated;
    std::size_t triangles = 0; // of what lies in volumes
    std::size_t open = 0;      // of them, those that are not proven: the budget is spent
};

// Sees effects one after another and keeps the last few results for each object that is there.
class ViewRefining {
public:
    // The budget of triangles is shared evenly by what lies in volumes; nothing has fewer than it
    // has. Some 8 us a triangle that comes into being, nothing for what was seen so before.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/curve_part.h"
#include "core/evaluation/shape.h"
#include "core/evaluation/walk.h"
#include "core/placement/shaper.h"
#include "core/refinement/refine.h"

#include <string>
#include <vector>

namespace trivar {

// What single steps tell of an object beside what is shown of it, one struct per step.

struct LayingEffects {        // of what lies on a stroke, or of a lattice
    Ref<Placement> placement; // null: it lies nowhere
    Ref<ShapedVolume> shaped; // null: nothing was done to its volume
    Ref<RayScene> lies_on;    // what its stroke falls on; null: nothing
};
struct TravelEffects {
    Ref<Journey> journey; // null: it does not travel
    Ref<Walk> walk;       // null: its feet are not locked to its travel
};
struct RefiningEffects {
    Ref<RefinementResult> refined; // null: its triangles are those of the model
};

struct SimplifyingEffects {
    std::size_t triangles_before = 0, triangles = 0; // of its shape; 0: it is not simplified
};

// What an object has come to after some of its steps. A step makes the next stage of a copy, so
// that no stage changes once another step has seen it.
struct Stage : SimplifyingEffects, LayingEffects, TravelEffects, RefiningEffects {
    Ref<Shape> shape;                 // what its source gives, as the file has it; never null
    std::vector<Part> parts;          // in the world; may be none
    std::vector<CurvePart> curves;    // the same
    std::vector<std::string> notices; // a missing file, a stroke that misses now
    std::vector<std::string> lacks;   // of those, why something is not here, as in Shape
    bool shows_nothing() const { return parts.empty() && curves.empty(); }
    // Why the stroke gave nothing, as a sentence for the user; the object then stands undeformed
    // where its transform says. A tool shows it and does not commit. Empty: it lies, or has none.
    std::string rejected;
};

} // namespace trivar

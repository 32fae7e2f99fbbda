// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/evaluation/part.h"
#include "core/evaluation/walk.h"
#include "core/placement/shaper.h"
#include "core/refinement/refine.h"

#include <map>

namespace trivar {

// What one object came to at one frame.
struct EvaluatedObject {
    Id id = 0;
    std::vector<Part> parts;
    Ref<std::vector<Material>> materials; // what face_material indexes
    Ref<Placement> placement;             // null where nothing was placed
    Ref<ShapedVolume> shaped;             // null where nothing was done to its volume
    Ref<Refined> refined;                 // null where its triangles are those of the model
    Ref<Journey> journey;                 // null where it does not travel
    Ref<Walk> walk;                       // null where its feet are not locked to that
    Ref<RayScene> lies_on;                // what its stroke falls on; null where there is none
    Lazy<Box> bounds;                     // world; asking for it deforms the parts
    std::vector<std::string> clips;       // what its file lets it play
    std::vector<std::string> notices;     // a missing file, a stroke that misses now
    std::vector<std::string> lacks;       // of those, why something is not here, as in Shape
    // Why the stroke gave nothing, as a sentence for the user; the object then stands undeformed
    // where its transform says. A tool shows it and does not commit. Empty: it lies, or has none.
    std::string rejected;
};

// The effects of a document. Objects that did not change keep their pointer.
struct Evaluated {
    std::map<Id, Ref<EvaluatedObject>> objects; // visible ones
    // Of this evaluation: import, subdivide, rays, springs, lift, volume, and deform, as far as the
    // parts were deformed for it.
    Timings timings;
};

} // namespace trivar

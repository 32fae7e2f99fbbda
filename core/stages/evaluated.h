// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/stages/stage.h"

#include <map>

namespace trivar {

// An EvaluatedObject is the result for one object at one frame: its last stage, and the answers
// that are often asked of it.
struct EvaluatedObject : Stage {
    Id id = 0;
    Ref<std::vector<Material>> materials; // the materials that face_material indexes
    Lazy<Box> bounds; // in the world; asking for them deforms the parts, but not tiles
    std::vector<std::string> clips; // the names of the clips in its file
};

// A FailedStep is a step of an object that ended by an exception. The object is as it was before.
struct FailedStep {
    Id object = 0;
    std::string step; // the type of the step
    std::string words;
    bool mistake = false; // of Trivar; false: there was not enough memory, for example
    bool operator==(const FailedStep&) const = default;
};

// An Evaluation holds the effects of a document. Objects that did not change keep their pointer.
struct Evaluation {
    std::map<Id, Ref<EvaluatedObject>> objects; // only visible ones
    std::vector<FailedStep> failed; // in their order; told in the notices of their objects, too
    // Times of this evaluation: import, subdivide, rays, springs, lift, volume, and deform for
    // those parts that had to be deformed.
    Timings timings;
};

} // namespace trivar

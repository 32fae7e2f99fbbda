// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "core/evaluation/stage.h"

#include <map>

namespace trivar {

// What one object came to at one frame: its last stage, and what everybody asks of it.
struct EvaluatedObject : Stage {
    Id id = 0;
    Ref<std::vector<Material>> materials; // what face_material indexes
    Lazy<Box> bounds;                     // world; asking for it deforms the parts
    std::vector<std::string> clips;       // what its file lets it play
};

// The effects of a document. Objects that did not change keep their pointer.
struct Evaluation {
    std::map<Id, Ref<EvaluatedObject>> objects; // visible ones
    // Of this evaluation: import, subdivide, rays, springs, lift, volume, and deform, as far as the
    // parts were deformed for it.
    Timings timings;
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <string>
#include <vector>

namespace trivar {

struct Stage;
struct IncisedMesh;

// IncisingEffects holds the facts that IncisingStep tells of an object beside its stage.
struct IncisingEffects {
    struct OfIncision {
        std::string refusal;          // why there is none, a sentence; empty: there is one
        double length = 0, depth = 0; // metres on the model
        double widest = 1;            // share of its width to which its walls let it open
        double least = 1;             // and the least share of its opening along it
        double least_depth = 1;       // the least share of its depth that there is room for
        std::string shortfall = {};   // why it does not go through or keeps its piece; or empty
        std::string notice = {};      // a sentence where only a part of the stroke is cut
        double open_to = 1;           // share of its length up to which it or its blade opens it
    };
    std::vector<OfIncision> incisions = {}; // by number
    Ref<Stage> uncut;                       // before it was incised; null: nothing is open
    struct OfMesh { // a mesh of the shape that stands open, with what it is when shut
        int slot = 0;
        Ref<IncisedMesh> incised;
        std::vector<std::size_t> incisions = {}; // by those of `incised`
    };
    std::vector<OfMesh> incised_meshes = {};
    std::size_t layers = 0; // how many of the shape's materials, the last ones, only walls show
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/document.h"
#include "core/evaluation/evaluated.h"
#include "core/evaluation/ray_meshes.h"

#include <memory>
#include <vector>

namespace trivar {

// What a step may look at beside the stage before it: the object as it is at one frame, and what
// the objects came to that it comes from.
struct StepInput {
    const Document& document;
    Id id;
    const Object& object;
    double frame;
    const std::map<Id, Ref<EvaluatedObject>>& done;
    RayMeshes& ray_meshes;
    Timings& timings;
    const Progress& progress;

    double seconds_since(int start_frame) const
    {
        return (frame - start_frame) / document.time.frames_per_second;
    }
};

// One of the steps that make an object of its shape, for one object: it keeps its last few results,
// and gives the stage before where it does nothing. Equal stages and equal input give the same
// pointer, as long as they are among those results.
class Step {
public:
    virtual ~Step() = default;
    // Throws Cancelled. Trouble with the object goes into the stage.
    virtual Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) = 0;
};

// The steps of one object in their order. Another step is a line here.
std::vector<std::unique_ptr<Step>> all_steps();

} // namespace trivar

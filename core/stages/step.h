// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/asset_store.h"
#include "core/rays/ray_meshes.h"
#include "core/stages/evaluated.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace trivar {

// The form of an object while all its incisions are shut. They `vanish`: it is the model before, to
// the bit. Or those that open in time `stay` as walls without area, so that a film has the same
// triangles in all frames.
enum class ShutIncisions : std::uint8_t { vanish, stay };

// A StepInput is the input of a step beside the stage before it: the object at one frame, and the
// results of the objects on which it depends.
struct StepInput {
    const Document& document;
    Id id;
    const Object& object;
    double frame;
    const std::map<Id, Ref<EvaluatedObject>>& done;
    RayMeshes& ray_meshes;
    Timings& timings;
    const Progress& progress;
    const AssetStore& assets; // for pictures
    ShutIncisions shut_incisions;

    double seconds_since(int start_frame) const
    {
        return (frame - start_frame) / document.time.frames_per_second;
    }
};

// A Step is one of the steps from an object's shape to the shown parts, for one object. It keeps
// its last few results and returns the stage before if it does nothing. Equal stages and equal
// input give the same pointer while they are among the kept results.
class Step {
public:
    virtual ~Step() = default;
    // Throws Cancelled. Trouble with the object is written into the stage.
    virtual Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) = 0;
};

// The steps of one object in their order. To add a step, add a line here.
std::vector<std::unique_ptr<Step>> all_steps();

} // namespace trivar

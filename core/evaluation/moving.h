// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/posing.h"
#include "core/evaluation/step.h"
#include "core/evaluation/walks.h"

namespace trivar {

// One of a procession, or the only one.
struct Member {
    Ref<Shape> posed; // null: as the model came
    Journey::Place place;
    bool operator==(const Member&) const = default;
};

// Lets an object stand as its clip has it at a frame: in the world, or where it is laid, with all
// that follow it, as far along the stroke as they have gone.
class Moving : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    struct TravelKey {
        Ref<Stage> before;
        Ref<Shape> posed; // as the first stands, for what is told of it
        std::vector<Member> members;
        Ref<Journey> journey;
        Ref<Walk> walk;
        bool operator==(const TravelKey&) const = default;
    };
    struct FreeKey {
        Ref<Stage> before;
        Ref<Shape> posed;
        glm::dmat4 to_world;
        bool feet_on_nothing; // they are to be locked to a travel, and there is no stroke
        bool operator==(const FreeKey&) const = default;
    };
    Ref<Stage> gone(const Ref<Stage>& before, const Ref<Shape>& posed, const StepInput& input);
    Ref<Journey> journey(const Ref<Stage>& laid, const Object& object);

    Posing posing_;
    Walks walks_;
    Recent<std::pair<Ref<Stage>, Travel>, Ref<Journey>> journeys_;
    Recent<TravelKey, Ref<Stage>> gone_;
    Recent<FreeKey, Ref<Stage>> free_;
};

} // namespace trivar

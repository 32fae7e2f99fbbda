// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/placement/journey.h"
#include "core/stages/step.h"
#include "core/stages/walk.h"
#include "core/steps/moving/posing.h"
#include "core/steps/moving/walks.h"

namespace trivar {

// A Member is one model of a procession, or the only model.
struct Member {
    Ref<Shape> posed; // null: in the pose of its file
    Journey::Place place;
    bool operator==(const Member&) const = default;
};

// MovingStep puts an object into the pose that its clip has at a frame: in the world, or where it
// is laid, with all its followers, as far along the stroke as they have gone.
class MovingStep : public Step {
public:
    Ref<Stage> operator()(const Ref<Stage>& before, const StepInput& input) override;

private:
    struct TravelKey {
        Ref<Stage> before;
        Ref<Shape> posed; // pose of the first member, for the notices
        std::vector<Member> members;
        Ref<Journey> journey;
        Ref<Walk> walk;
        bool operator==(const TravelKey&) const = default;
    };
    struct FreeKey {
        Ref<Stage> before;
        Ref<Shape> posed;
        glm::dmat4 to_world;
        bool feet_on_nothing; // its feet should be locked to a travel, and there is no stroke
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

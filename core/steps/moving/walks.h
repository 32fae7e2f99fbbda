// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/placement/journey.h"
#include "core/stages/stage.h"
#include "core/stages/walk.h"

namespace trivar {

// Walks measures the walks of one object and keeps the last result.
class Walks {
public:
    // The walk of the feet; null where they are not to be locked. The object is laid in the pose of
    // its file, `turned` being its rotation and scale.
    Ref<Walk> operator()(const Ref<Shape>& shape, const Playing& playing, const Ref<Stage>& laid,
                         const Ref<Journey>& journey, const PlacementParameters& parameters,
                         const glm::dmat3& turned);

private:
    struct Walker {
        Ref<Shape> shape;
        Ref<Stage> laid;
        Ref<Journey> journey;
        Playing playing;
        bool operator==(const Walker&) const = default;
    };
    struct Steps { // of a clip over the ground
        Ref<Model> model;
        std::string clip;
        glm::dvec3 up;
        double floor;
        bool operator==(const Steps&) const = default;
    };
    Recent<Walker, Ref<Walk>> walks_{1};
    Recent<Steps, Ref<Gait>> gaits_{1};
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/stage.h"

namespace trivar {

// Measures the walks of one object and keeps the last.
class Walks {
public:
    // Null where its feet are not to be locked. The object is laid as it came, and `turned`.
    Ref<Walk> operator()(const Ref<Shape>& shape, const Playing& playing, const Ref<Stage>& laid,
                         const Ref<Journey>& journey, const PlacementParameters& parameters,
                         const glm::dmat3& turned);

private:
    Ref<Gait> gait_of(const Ref<Model>& model, const std::string& clip, const glm::dvec3& up,
                      double floor);

    struct Known {
        Ref<Shape> shape;
        Ref<Stage> laid;
        Ref<Journey> journey;
        Playing playing;
        Ref<Walk> walk;
    };
    std::optional<Known> known_;
    struct Measured {
        Ref<Model> model;
        std::string clip;
        double floor;
        Ref<Gait> gait;
    };
    std::optional<Measured> measured_;
};

} // namespace trivar

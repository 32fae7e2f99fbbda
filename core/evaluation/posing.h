// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/evaluation/shape.h"
#include "core/mesh/foot_lock.h"

namespace trivar {

// The time of a clip, some seconds after it began to be played (before: as at 0).
double clip_time_s(const Clip& clip, const Playing& playing, double seconds);

// How one object's shape stands, while it plays a clip; keeps the last few.
class Posing {
public:
    // The shape itself where nothing is played. A clip that its file lacks is a notice.
    Ref<Shape> operator()(const Ref<Shape>& rest, const Playing& playing, double seconds);
    // At a time of a clip; with a gait, its planted feet where the ground carries them.
    Ref<Shape> at(const Ref<Shape>& rest, const Clip& clip, double time_s,
                  const Ref<Gait>& gait = nullptr);
    void keep(std::size_t poses) { poses_.keep(poses); }

private:
    struct Pose {
        Ref<Shape> rest;
        std::string clip;
        double time_s;
        Ref<Gait> gait;
        bool operator==(const Pose&) const = default;
    };
    Recent<Pose, Ref<Shape>> poses_;
};

} // namespace trivar

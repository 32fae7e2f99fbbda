// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/recent.h"
#include "core/document/object.h"
#include "core/stages/shape.h"
#include "core/walking/foot_lock.h"

namespace trivar {

// The time of a clip, `seconds` after it began to play; before that, the clip's time at 0.
double clip_time_s(const Clip& clip, const Playing& playing, double seconds);

// Posing gives an object's shape as it stands while a clip plays, and keeps the last few results.
class Posing {
public:
    // The given shape itself where nothing is played. A clip that the file lacks becomes a notice.
    Ref<Shape> operator()(const Ref<Shape>& rest, const Playing& playing, double seconds);
    // The shape at a time of a clip. With a gait, planted feet are where the ground carries them.
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

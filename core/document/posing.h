// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/shapes.h"

namespace trivar {

// The time of a clip, some seconds after it began to be played (before: as at 0).
double clip_time_s(const Clip& clip, const Playing& playing, double seconds);

// How one object's shape stands, while it plays a clip; keeps the last few.
class Posing {
public:
    // The shape itself where nothing is played. A clip that its file lacks is a notice.
    Ref<Shape> operator()(const Ref<Shape>& rest, const Playing& playing, double seconds);

private:
    struct Known {
        Ref<Shape> rest;
        std::string clip;
        double time_s;
        Ref<Shape> shape;
    };
    std::vector<Known> known_; // the latest first
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/painted_surface.h"

#include <string>
#include <vector>

// This header holds what the tool Tiles keeps between strokes.

namespace trivar {

struct StrokeEnd { // of the last stroke
    Id layer = 0, base = 0;
    SurfaceHit at;
};

struct PickedPoint { // that tiles head to
    Id base = 0;
    glm::dvec3 p_rest{0}, p_world{0};
};

struct BegunLayer { // the last layer that began with a stroke, and with what
    Id layer = 0;
    std::vector<std::string> files;
    double overlap = 0;
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

struct Report {
    int vertices = 0, faces = 0, quads = 0;
    int open = 0;        // directed edges without their reverse
    int nonmanifold = 0; // directed edges used twice
    int pieces = 0;
    float worst_angle_deg = 180;
    float under_20_deg = 0; // per cent of the triangles written
    float volume = 0;       // of the parts at their nodes' origins
    vec3 lo{1e9f}, hi{-1e9f};
};

// Measures a model as it will be written.
Report check(const Model& model);

} // namespace make

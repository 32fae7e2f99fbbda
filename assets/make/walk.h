// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

// Walks in place. A standing foot moves straight back at constant speed, so a model that advances
// by travel / duty a cycle along +x keeps its standing feet where they are.
namespace make {

struct Step {
    float x, lift; // of the foot, relative to its rest
};
Step step_at(float phase, float travel, float duty, float lift); // phase in cycles; stance first

struct Bend {
    float upper, lower; // radians about +z
};
// Two links from the origin to (x, y); side +1 or -1 says which way the joint bends.
Bend reach(float x, float y, float upper_length, float lower_length, float side);

inline quat rotation(float angle, vec3 axis)
{
    return glm::angleAxis(angle, axis);
}

// Between two joints of a spine along x, which are at falling x, a point goes with both.
Influence along_x(const std::vector<float>& x, vec3 p);

} // namespace make

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/volumes/volumes.h"

namespace make {

// A density of electrons as a sum of Gaussians on a grid. Lengths are in Angstrom, which a file
// says as millimetres.
class Density {
public:
    Density(glm::ivec3 size, vec3 lo, float step);
    // A ball of charge: `electrons` in all, with a standard deviation. 5 ns a sample near it.
    void add(vec3 center, float electrons, float deviation);
    // Charge along a bond: cigars, with the deviation along and across it.
    void add_bond(vec3 a, vec3 b, float electrons, float along, float across);
    Volume scaled(float factor) const; // samples, times that, rounded

private:
    glm::ivec3 size_;
    vec3 lo_;
    float step_;
    std::vector<float> samples_;
};

} // namespace make

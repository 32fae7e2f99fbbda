// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/volumes/phantom.h"

// A mandible is thought of as a curtain: a side view that is drawn over the length of an arch in
// plan, with a thickness everywhere. Millimetres; x to the left, y to the back, z up.
namespace make {

class JawArch {
public:
    JawArch();
    // Length along the left half of the arch from the middle, and how far outside of it.
    vec2 unrolled(vec2 plan) const;
    vec3 at(float along, float outside, float z) const;
    vec2 tangent(float along) const; // in plan, away from the middle

private:
    std::vector<vec2> points_;
    std::vector<float> lengths_;
};

// JawTeeth are the teeth of the left half; the right half mirrors them.
struct JawTeeth {
    Tissue crowns, roots, pulps;
};
JawTeeth jaw_teeth(const JawArch& arch);
float over_roots(float along); // 0 to 1: how near a root the length along the arch is

} // namespace make

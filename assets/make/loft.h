// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

// A monotone cubic through (x, y) keys: it never overshoots, so lofts have no lumps.
// F. Fritsch, J. Butland 1984.
class Curve {
public:
    Curve() = default;
    Curve(std::vector<vec2> keys);
    float operator()(float x) const;

private:
    std::vector<vec2> keys_;
    std::vector<float> slopes_;
};

struct Station {
    float x, y;        // along, and the centre's height
    float w, up, down; // half width, reach above and below
    float squareness;  // exponent of the superellipse: 2 round, more is boxier
};

// Superelliptic cross-sections strung along +x; called with a point it gives the distance.
class Loft {
public:
    Loft(const std::vector<Station>& stations);
    float operator()(vec3 p) const;

private:
    float level(float x, float beyond, float y, float z) const;
    Curve y_, width_, up_, down_, squareness_;
    float begin_, end_;
};

// A round tube along a smooth curve; keys are xyz and radius.
class Limb {
public:
    Limb(const std::vector<vec4>& keys, int segments = 10);
    float operator()(vec3 p) const;

private:
    std::vector<vec4> spine_;
    vec3 lo_{1e9f}, hi_{-1e9f};
    float widest_ = 0;
};

} // namespace make

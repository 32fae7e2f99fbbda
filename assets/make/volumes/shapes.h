// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/field.h"

// Shapes of anatomy as signed distances, in millimetres, negative inside; each knows its box.
namespace make {

struct Solid {
    vec3 lo, hi; // its surface lies between
    Distance distance;
};

struct Section { // of a tube: where, and half the width across and along the tube's `up`
    vec3 at;
    float across, along;
};

// A tube of elliptic sections along a Catmull-Rom curve, with round ends; `up` turns the sections.
Solid tube(const std::vector<Section>& sections, vec3 up = {0, 0, 1}, int segments = 5);

// An ellipsoid, turned about an axis.
Solid blob(vec3 center, vec3 radii, float angle_deg = 0, vec3 axis = {0, 0, 1});

// A box with round edges, turned about an axis.
Solid block(vec3 center, vec3 half, float round, float angle_deg = 0, vec3 axis = {0, 0, 1});

// A plate: the outline, smoothed, in the plane of the unit vectors x and y through the origin.
Solid plate(vec3 origin, vec3 x, vec3 y, const std::vector<vec2>& outline, float half, float round);

Solid ring(vec3 center, vec3 axis, float radius, float thickness);

// A solid that any distance within a box gives.
Solid solid(vec3 lo, vec3 hi, Distance distance);

// Several, with soft edges between them.
Solid joined(const std::vector<Solid>& solids, float blend);

// With its surface moved outward; what is taken off by a grown neighbour leaves a joint's space.
Solid grown(const Solid& solid, float by);

// Across x = 0.
Solid mirrored(const Solid& solid);

} // namespace make

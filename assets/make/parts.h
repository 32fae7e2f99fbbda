// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

// Hard-surface pieces, each closed.
namespace make {

Mesh bevel_box(vec3 half, float bevel, int bevel_segments = 2, glm::ivec3 divisions = {2, 2, 2});
Mesh ball_mesh(float radius, int n = 6); // a cube blown up: all quads

// About +y from (radius, height) pairs, bottom to top; loop: the profile is a closed ring.
Mesh lathe(const std::vector<vec2>& profile, int n, bool loop = false);
Mesh cylinder(float r0, float r1, float height, float bevel, int n = 24, int rows = 1);

// Keys are xyz and radius; ends are round with `cap` rings each.
Mesh tube(const std::vector<vec4>& path, int n, bool loop = false, int cap = 3);
std::vector<vec4> curve(const std::vector<vec4>& keys, int segments); // Catmull-Rom

// An outline in xy, extruded along z from -half to half with `rows` rings between.
Mesh prism_mesh(const std::vector<vec2>& outline, float half, float bevel, int rows = 1);

// A Plate is a thin sheet over the grid u x v, both ascending, seen from above with u to the right.
struct Plate {
    std::vector<float> u, v;
    std::function<vec3(vec2)> above, below;
    std::function<vec3(vec2, bool)> color; // sRGB; true: above
};
Mesh plate(const Plate& shape); // joined round its rim

} // namespace make

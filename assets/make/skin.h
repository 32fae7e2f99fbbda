// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

void both(std::vector<Mesh>& parts, const Mesh& mesh); // adds it and its mirror image
Mesh cone(vec3 base, vec3 tip, float radius, int material, int n = 8); // teeth and claws
Mesh plain(Mesh mesh, int material);                                   // without vertex colours

// Cylindrical texture coordinates: u about the axis in 0..1, v along it. The seam is under the
// belly (about x, at the height center_y(x)) or at the back (about y, through axis_xz).
void wrap_about_x(Mesh& mesh, const std::function<float(float)>& center_y);
void wrap_about_x(Mesh& mesh, float center_y);
void wrap_about_y(Mesh& mesh, vec2 axis_xz);

} // namespace make

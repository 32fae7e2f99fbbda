// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

namespace make {

float polygon(vec2 p, const std::vector<vec2>& corners);    // signed distance, negative inside
float path_distance(vec2 p, const std::vector<vec2>& path); // to an open polyline

// Corners cut back by at most r and rounded with n segments each.
std::vector<vec2> fillet(const std::vector<vec2>& outline, float r, int n = 5, bool closed = true);

// Catmull-Rom through the points, n segments each.
std::vector<vec2> smooth_loop(const std::vector<vec2>& points, int n = 6, bool closed = true);

} // namespace make

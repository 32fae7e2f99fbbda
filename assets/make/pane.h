// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/field.h"

namespace make {

using Place = std::function<vec3(vec2)>; // from an outline's plane to where it is thrown from

// Glass, lamps and vents: a star-shaped outline thrown onto the body along dir, raised by `out`
// with a rim, closed underneath.
Mesh pane(const Distance& body, const std::vector<vec2>& outline, const Place& at, vec3 dir,
          float out, int rows = 7, float rim = .0022f);

// A panel gap: a thin cord laid half into the body.
Mesh gap(const Distance& body, const std::vector<vec2>& path, const Place& at, vec3 dir, float r);

} // namespace make

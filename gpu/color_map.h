// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"

#include <array>

namespace trivar::gpu {

// These functions give colours for numbers. The lightness in OKLab (Ottosson 2020) is even and
// orders them, so that they survive colour blindness and grey printing. Display-linear; t is
// limited to its range.
glm::vec3 sequential_color(float t); // 0..1: indigo, teal, pale yellow
glm::vec3 diverging_color(float t);  // -1..1: blue, nearly white, rust
glm::vec3 folded_color(bool stripe); // two magentas that no value has

// The map of a picture at even steps over its range; shaders interpolate between them.
inline constexpr int map_steps = 32;
std::array<glm::vec4, map_steps + 1> map_colors(const ValueColors& colors);

} // namespace trivar::gpu

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"

#include <array>

namespace trivar::gpu {

// Colours for numbers, even in the lightness of OKLab (Ottosson 2020) and ordered by it first, so
// that they survive colour blindness and grey printing. Display-linear; t is cut to its range.
glm::vec3 sequential_color(float t); // 0..1: indigo, teal, pale yellow
glm::vec3 diverging_color(float t);  // -1..1: blue, nearly white, rust
glm::vec3 folded_color(bool stripe); // two magentas, no value's colour

// The map of a picture at even steps over its range, for shaders to read between.
inline constexpr int map_steps = 32;
std::array<glm::vec4, map_steps + 1> map_colors(const ValueColors& colors);

} // namespace trivar::gpu

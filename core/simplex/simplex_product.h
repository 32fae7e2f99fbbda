// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace trivar {

// Sums for 8 points at once: out[3 r + axis][point] = sum_f weights[f][r][point] *
// displacements[functions[f]][axis] for r < rows. At most 4 rows.
using EightPoints = std::array<std::array<float, 8>, 12>;
EightPoints simplex_product(std::span<const std::uint32_t> functions, const float* weights,
                            int rows, std::span<const glm::vec4> displacements);

} // namespace trivar

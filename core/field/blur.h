// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// The samples of a grid, x fastest, after (1 2 1)/4 was applied that many times along each of x, y
// and z; beyond the grid they are mirrored. That is nearly a Gauss bell of sqrt(times / 2) voxels.
// Second derivatives of what was measured need some of it. O(#samples * times).
template <class Sample>
std::vector<float> blurred(std::span<const Sample> samples, const glm::ivec3& size,
                           const glm::ivec3& times);
template <class Sample>
std::vector<float> blurred(std::span<const Sample> samples, const glm::ivec3& size, int times)
{
    return blurred(samples, size, glm::ivec3(times));
}

} // namespace trivar

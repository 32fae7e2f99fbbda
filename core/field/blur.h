// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// Blurs samples by (1 2 1)/4, nearly a Gauss bell of sqrt(times / 2) voxels. Second derivatives of
// measured data need some of it.
//   samples  x fastest; mirrored beyond the grid
//   size     number of samples along each axis
//   times    number of passes along x, y and z
// O(#samples * times).
template <class Sample>
std::vector<float> blurred(std::span<const Sample> samples, const glm::ivec3& size,
                           const glm::ivec3& times);
template <class Sample>
std::vector<float> blurred(std::span<const Sample> samples, const glm::ivec3& size, int times)
{
    return blurred(samples, size, glm::ivec3(times));
}

} // namespace trivar

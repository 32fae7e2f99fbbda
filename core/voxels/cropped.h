// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/voxel_grid.h"

#include <span>

namespace trivar {

// A SampleBox is a box of samples of a grid, by the first and the last one along each axis, which
// are both in it. It holds at least two of each axis.
struct SampleBox {
    glm::ivec3 first{0}, last{1};
    glm::ivec3 size() const { return last - first + 1; }
    bool operator==(const SampleBox&) const = default;
};

// The box whose corners are the samples nearest to two places, told as shares of a grid of that
// size along its axes. Where these are less than a cell apart it has the cell there.
SampleBox sample_box(const glm::ivec3& size, const glm::vec3& low, const glm::vec3& high);

// The values in a box of a grid of that size, x fastest. O(#samples of the box).
template <class Value>
std::vector<Value> cropped(std::span<const Value> values, const glm::ivec3& size,
                           const SampleBox& box)
{
    std::vector<Value> out;
    const glm::ivec3 part = box.size();
    out.reserve(static_cast<std::size_t>(part.x) * static_cast<std::size_t>(part.y) *
                static_cast<std::size_t>(part.z));
    for (int k = box.first.z; k <= box.last.z; ++k)
        for (int j = box.first.y; j <= box.last.y; ++j) {
            const auto row = static_cast<std::size_t>(k) * static_cast<std::size_t>(size.y) +
                             static_cast<std::size_t>(j);
            const auto from = values.begin() +
                              static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(size.x) +
                                                          static_cast<std::size_t>(box.first.x));
            out.insert(out.end(), from, from + part.x);
        }
    return out;
}

// A grid of the samples in a box of another one, at the same places.
VoxelGrid cropped(const VoxelGrid& grid, const SampleBox& box);
// Returns the transform of the cropped grid, given that of the full one.
glm::dmat4 cropped_place(const glm::dmat4& to_metres, const SampleBox& box);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/voxel_grid.h"

#include <array>
#include <cstdint>
#include <string>

namespace trivar {

// A VolumeSummary is shown before a volume is taken.
struct VolumeSummary {
    glm::ivec3 size{0};
    std::string type;               // "signed 16-bit whole numbers"
    glm::dvec3 spacing_mm{0};       // length of a step along each axis of the grid
    std::size_t bytes = 0;          // of the samples in memory
    double least = 0, greatest = 0; // of the finite values; 0 where there are none
    std::size_t not_finite = 0;     // number of samples that are not a number or infinite
    // Numbers of finite values in equal parts of [least, greatest]; the last part has its end.
    std::array<std::uint64_t, 256> histogram{};
    bool operator==(const VolumeSummary&) const = default;
};

// Two passes over the samples, in parallel; the same for any number of threads.
VolumeSummary summary_of(const VoxelGrid& grid);

} // namespace trivar

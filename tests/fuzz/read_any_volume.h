// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/volume_summary.h"

#include <cstddef>
#include <cstdlib>
#include <string>

namespace trivar::testing {

// Checks that a volume that was read is sound: as many samples as its size says, at least two along
// each axis, a place that spans space, and a summary. The first bytes choose the reader.
inline int read_any_volume(const unsigned char* data, std::size_t size, const std::string& name)
{
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const VoxelGrid grid = read_volume_bytes(bytes, name, "").grid;
        const std::size_t count =
            std::visit([](const auto& samples) { return samples.size(); }, grid.samples);
        if (grid.size.x < 2 || grid.size.y < 2 || grid.size.z < 2 || count != grid.count())
            std::abort();
        if (grid.slope == 0 || !(glm::determinant(glm::dmat3(grid.to_metres)) != 0)) std::abort();
        if (summary_of(grid).not_finite >= count) std::abort();
    } catch (const Rejected&) {
    }
    return 0;
}

} // namespace trivar::testing

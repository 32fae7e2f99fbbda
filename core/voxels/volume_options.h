// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/raw_layout.h"
#include "core/voxels/voxel_grid.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// How a volume is read, beside what its files say.
struct ReadVolumeOptions {
    std::uintmax_t max_bytes = std::uintmax_t{16} << 30; // of all files of the volume together
    // How a file without a head is laid out; empty: as its name says, if that fits its bytes.
    std::optional<RawLayout> raw;
    // Distances between samples of files that say none, in their unit: raw files and pictures.
    glm::dvec3 spacing{1};
    // The unit of the files; empty: as they say themselves, else millimetres.
    std::optional<double> metres_per_unit;
    // The DICOM series to take, by its SeriesInstanceUID; empty: the one with the most slices.
    std::string series;
};

// A volume that was read, with the other files that it was read from: their names in the folder of
// the file that was opened, or in the folder, with '/', sorted.
struct ReadVolume {
    VoxelGrid grid;
    std::vector<std::string> companions;
};

} // namespace trivar

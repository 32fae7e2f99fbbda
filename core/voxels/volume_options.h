// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/cropped.h"
#include "core/voxels/raw_layout.h"
#include "core/voxels/voxel_grid.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// The treatment of a part that does not fit into memory: it is refused, coarsened further until it
// fits, or only its head is read.
enum class TooLarge { refuse, coarsen, head };

// ReadVolumeOptions tell how a volume is read, beside what its files say.
struct ReadVolumeOptions {
    std::uintmax_t max_bytes = std::uintmax_t{1} << 44; // of all files of the volume together
    // The memory that samples may take, counting also `bytes_beside` per sample that the caller
    // takes beside them; the limit holds for a file that has to be read as a whole, too.
    std::uintmax_t memory_bytes = std::uintmax_t{16} << 30;
    std::uintmax_t bytes_beside = 0;
    // The layout of a file without a head; empty: as its name says, if that fits its bytes.
    std::optional<RawLayout> raw;
    // Distances between samples of files that say none, in their unit: raw files and pictures.
    glm::dvec3 spacing{1};
    // The unit of the files; empty: as they say themselves, else millimetres.
    std::optional<double> metres_per_unit;
    // The DICOM series to take, by its SeriesInstanceUID; empty: the one with the most slices.
    std::string series;

    // The part that is read: a box of samples, none of which is all of them, and of those one for
    // `coarsen` along each axis, as cropped() and then coarsened() make it, to the bit. Memory is
    // taken for the part and `coarsen` slices of the box.
    std::optional<SampleBox> box;
    int coarsen = 1;
    TooLarge if_too_large = TooLarge::refuse;
    // The size and the place are read, but no samples; the grid has none then.
    bool head_only = false;
    // Gets the slices of the part as they come, the first first, instead of the grid; the samples
    // of one are taken for the memory then.
    std::function<void(int slice, const VoxelGrid::Samples& samples)> each_slice;
};

// The part of a volume that was read.
struct GridPart {
    glm::ivec3 whole{0}; // number of samples of the volume along each axis
    SampleBox box;       // of these
    int coarsen = 1;
    std::size_t bytes_per_sample = 1; // in memory
    glm::ivec3 step() const;          // as coarsened() takes `coarsen` for the box
    glm::ivec3 size() const;          // number of samples of the part
    std::uint64_t count() const;
    bool operator==(const GridPart&) const = default;
};

// A volume that was read, with the other files that it was read from: their names in the folder of
// the file that was opened, or in the folder, with '/', sorted.
struct ReadVolume {
    VoxelGrid grid;
    std::vector<std::string> companions;
    GridPart part;
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/slice_order.h"
#include "core/voxels/voxel_grid.h"

#include <vector>

namespace trivar {

// SliceSamples are the samples of a series, slice by slice as files are decoded, in any order. All
// slices have one type and one number of samples. Where they are scaled differently, values are
// kept as floats, and slope and intercept are 1 and 0.
class SliceSamples {
public:
    SliceSamples(const std::vector<PlacedSlice>& slices, SampleType type, std::size_t per_slice);

    // Takes the samples of slices `first`, `first` + 1, ... as they stand behind one another.
    void put(std::size_t first, const VoxelGrid::Samples& samples);

    // The samples in the order of the grid, interpolated where the series is uneven, whole numbers
    // rounded. They are taken out.
    VoxelGrid::Samples ordered(const SliceOrder& order);

    double slope() const { return slope_; }
    double intercept() const { return intercept_; }
    bool scaled_alike() const { return alike_; }

private:
    const std::vector<PlacedSlice>& slices_;
    std::size_t per_slice_;
    double slope_ = 1, intercept_ = 0;
    bool alike_ = true;
    VoxelGrid::Samples samples_; // slices behind one another
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/slice_order.h"
#include "core/voxels/voxel_grid.h"

#include <functional>
#include <vector>

namespace trivar {

// SliceSamples gives the samples of a series, slice by slice in the order of the grid. All slices
// have one type and one number of samples. Where they are scaled differently, values are kept as
// floats, and slope and intercept are 1 and 0. A file is decoded when the first of its slices is
// wanted, and forgotten after the last one.
class SliceSamples {
public:
    // `first` has the number of the first slice of each file, and the end of the last. It and the
    // slices outlive this.
    SliceSamples(const std::vector<PlacedSlice>& slices, const std::vector<std::size_t>& first,
                 SampleType type, std::size_t per_slice);

    double slope() const { return slope_; }
    double intercept() const { return intercept_; }
    bool scaled_alike() const { return alike_; }
    SampleType type() const { return alike_ ? type_ : SampleType::f32; } // of what it gives

    // Calls take(samples) for those slices of the grid for which wanted(slice), in order,
    // interpolated where the series is uneven, whole numbers rounded. `decode` gives the samples of
    // a file.
    void for_slices(const SliceOrder& order, const std::function<bool(std::size_t)>& wanted,
                    const std::function<VoxelGrid::Samples(std::size_t file)>& decode,
                    const std::function<void(const VoxelGrid::Samples&)>& take);

private:
    std::size_t file_of(std::size_t slice) const;
    VoxelGrid::Samples values(std::size_t slice, const VoxelGrid::Samples& of_file) const;

    const std::vector<PlacedSlice>& slices_;
    const std::vector<std::size_t>& first_;
    SampleType type_;
    std::size_t per_slice_;
    double slope_ = 1, intercept_ = 0;
    bool alike_ = true;
};

} // namespace trivar

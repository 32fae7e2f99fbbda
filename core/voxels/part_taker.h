// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/voxels/byte_stream.h"
#include "core/voxels/sample_type.h"
#include "core/voxels/volume_options.h"

#include <string>

namespace trivar {

// A PartTaker makes the part of a volume that the options ask for, of its samples as they come: it
// crops and coarsens slice by slice. Memory is taken for the part and for `coarsen` slices.
class PartTaker {
public:
    // The options and the name outlive it. Throws Rejected for a box beyond the volume. A part that
    // does not fit into the memory is refused when samples are taken, so that it is said first
    // where a file does not have them.
    PartTaker(const SampleBlock& whole, const ReadVolumeOptions& options, const std::string& name,
              Progress progress = {});

    const GridPart& part() const { return part_; }
    bool wants_samples() const { return wants_samples_; }
    // Whether samples of that slice of the volume are in the part. None is where it wants none.
    bool wants(std::int64_t slice) const;

    // Takes all samples of the volume in the order of files, x fastest. The stream has just these
    // bytes and sees to it that it has them all (exactly()).
    void take(const ByteStream& bytes, ByteOrder order);
    // Takes all samples of the volume.
    void take(const TakenSamples& all);
    // Takes the samples of the next slice of the volume that it wants.
    void take_slice(const VoxelGrid::Samples& slice);

    // The samples of the part and how many of those that were read are rounded.
    TakenSamples finish() { return {std::move(out_), rounded_}; }

private:
    void fit();
    void check_fits() const; // throws Rejected
    void add_rows(const VoxelGrid::Samples& rows, std::size_t first_row, std::size_t count);
    void end_slice();

    SampleBlock whole_;
    const ReadVolumeOptions& options_;
    const std::string& name_;
    Progress progress_;
    GridPart part_;
    bool wants_samples_ = true;
    std::string too_large_;         // why it is refused; empty: it fits
    VoxelGrid::Samples out_, slab_; // the slab has slices of the box until one is made of them
    int in_slab_ = 0, given_ = 0;   // numbers of slices: in the slab, of the part
    std::size_t rounded_ = 0;
};

} // namespace trivar

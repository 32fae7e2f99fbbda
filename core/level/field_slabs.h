// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/voxel_field.h"

#include <functional>

namespace trivar {

// A SlabPlan says in which slabs data that are larger than memory are worked on: so many slices at
// a time, with some more on both sides, of which the coefficients at the ends of a slab depend.
struct SlabPlan {
    glm::ivec3 size{0};      // number of samples along each axis
    int slices = 0;          // of a slab, a multiple of 8; the last one has what is left
    int halo = 0;            // slices on either side, a multiple of 8
    std::uint64_t bytes = 0; // of samples and coefficients at a time, about
};

// The bytes that a function takes per sample, with the sample: 6 to 18 for 16 bits.
std::uint64_t field_bytes(std::size_t bytes_per_sample, const VoxelFieldOptions& options);

// Slices on either side of samples, on which the function there depends to nearly all its bits.
int slab_halo(const VoxelFieldOptions& options);

// Plans the largest slabs that fit into memory.
//   size              of the data, after `options.coarsen` was done
//   bytes_per_sample  of the data
//   memory_bytes      for samples and coefficients of one slab
// With 32 slices on either side the coefficients have nearly all the bits of those of the whole; if
// these do not fit there are 16, and they err by 1e-9 of their size. Throws Rejected if a slab does
// not fit.
SlabPlan slab_plan(const glm::ivec3& size, std::size_t bytes_per_sample,
                   const VoxelFieldOptions& options, std::uint64_t memory_bytes);

// A FieldSlab is the function of a slab of data, at the places of the whole. See VoxelField.
class FieldSlab {
public:
    // `samples` are those of all slices from `held` on that are there; the slab is from `first` to
    // `end`. They outlive it.
    FieldSlab(const VoxelGrid::Samples& samples, const SlabPlan& plan,
              const VoxelFieldOptions& options, int held, int first, int end);

    int first() const { return first_; }
    int end() const { return end_; }
    const ScalarField<float>& field() const { return field_; }
    // The level's mesh as SlabCurves wants it, `level` told as a sample.
    LevelMesh level(float level) const;
    // The body as far as it is in the slab and a slice beyond, `side` that of samples.
    LevelBody body(float level, LevelSide side) const;

private:
    const VoxelGrid::Samples& samples_;
    int first_, end_;
    std::vector<float> blurred_; // samples; empty: those given
    ScalarField<float> field_;
    FieldHulls hulls_;
    std::vector<float> lattice_; // values; empty: the samples
};

// Calls its argument with the number and the samples of every slice, the first first.
using SliceReader =
    std::function<void(const std::function<void(int, const VoxelGrid::Samples&)>& slice)>;

// Calls use(slab) for all slabs in order, in one pass over the slices.
void for_slabs(const SlabPlan& plan, const VoxelFieldOptions& options, const SliceReader& read,
               const std::function<void(const FieldSlab&)>& use);

} // namespace trivar

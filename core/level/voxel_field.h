// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/level/level_body.h"
#include "core/level/level_mesh.h"
#include "core/mesh/mesh.h"
#include "core/voxels/cropped.h"

namespace trivar {

// VoxelFieldOptions say how volume data become a function.
struct VoxelFieldOptions {
    FieldSpline spline = FieldSpline::interpolating;
    FieldOrder order = FieldOrder::cubic;
    int blur = 0;    // see blurred()
    int coarsen = 1; // see coarsened(); before all else
    bool operator==(const VoxelFieldOptions&) const = default;
};

// A VoxelField is volume data as a function, with all that its levels are found by. Levels are told
// as values of the data; the function itself is of samples, which are slope and intercept away from
// these.
class VoxelField {
public:
    // O(#samples); 4 bytes per sample beside the grid, 8 where it is blurred or smoothed. Throws
    // Rejected.
    VoxelField(Ref<VoxelGrid> grid, const VoxelFieldOptions& options);
    // The same function over a box of another one's samples; see ScalarField::part(). O(#samples
    // of the box).
    VoxelField(const VoxelField& whole, const SampleBox& box);

    // The grid that it is of; voxels are those of this grid.
    const VoxelGrid& grid() const { return *grid_; }
    const ScalarField<float>& field() const { return field_; }
    const FieldHulls& hulls() const { return hulls_; }
    int blur() const { return blur_; } // of its options
    // Whether its values at the points of the grid are the samples.
    bool goes_through_samples() const { return blurred_.empty() && lattice_.empty(); }

    // The level at a value; on which side of it, as samples, a body is whose values are on a side.
    LevelMesh level(double value, LevelAccuracy accuracy = LevelAccuracy::exact) const;
    LevelSide side(LevelSide of_values) const;
    // Quick levels at values a fiftieth of all that there are below and above one, by which
    // draw_levels() tells lines that last from those that do not.
    std::vector<LevelMesh> nearby_levels(double value) const;
    LevelBody body(const LevelMesh& level, LevelSide of_values) const
    {
        return {field_, hulls_, level.level, side(of_values)};
    }
    // The closed surface of such a body; see level_surface().
    Mesh surface(const LevelMesh& level, LevelSide of_values, const glm::dmat4& to_space) const;
    std::size_t bytes() const; // all of it, with the grid

private:
    // Calls use(values) with the function's values at the points of its lattice.
    auto with_lattice(auto&& use) const;

    Ref<VoxelGrid> grid_;
    int blur_;
    std::vector<float> blurred_; // samples; empty: the grid's own
    ScalarField<float> field_;
    FieldHulls hulls_;
    std::vector<float> lattice_; // values; empty: the samples
};

} // namespace trivar

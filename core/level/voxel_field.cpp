// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/voxel_field.h"

#include "core/field/blur.h"
#include "core/level/level_surface.h"
#include "core/voxels/coarsened.h"

namespace trivar {
namespace {

std::vector<float> samples_after(const VoxelGrid& grid, int blur)
{
    if (blur <= 0) return {};
    return std::visit(
        [&](const auto& samples) { return blurred(std::span(samples), grid.size, blur); },
        grid.samples);
}

ScalarField<float> field_of(const VoxelGrid& grid, const std::vector<float>& blurred,
                            const VoxelFieldOptions& options)
{
    const auto of = [&](const auto& samples) {
        return ScalarField<float>(std::span(samples), grid.size, options.spline, options.order);
    };
    return blurred.empty() ? std::visit(of, grid.samples) : of(blurred);
}

// Crops values given for each sample; empty stays empty.
std::vector<float> part_of(const std::vector<float>& values, const glm::ivec3& size,
                           const SampleBox& box)
{
    if (values.empty()) return {};
    return cropped(std::span(values), size, box);
}

} // namespace

VoxelField::VoxelField(Ref<VoxelGrid> grid, const VoxelFieldOptions& options)
    : grid_(options.coarsen > 1 ? make_ref(coarsened(*grid, glm::ivec3(options.coarsen)))
                                : std::move(grid)),
      blur_(options.blur),
      blurred_(samples_after(*grid_, options.blur)),
      field_(field_of(*grid_, blurred_, options)),
      hulls_(field_)
{
    if (options.spline == FieldSpline::interpolating || options.order == FieldOrder::linear) return;
    lattice_ = lattice_values(field_);
    blurred_ = {};
}

VoxelField::VoxelField(const VoxelField& whole, const SampleBox& box)
    : grid_(make_ref(cropped(*whole.grid_, box))),
      blur_(whole.blur_),
      blurred_(part_of(whole.blurred_, whole.grid_->size, box)),
      field_(whole.field_.part(box.first, box.size())),
      hulls_(field_),
      lattice_(part_of(whole.lattice_, whole.grid_->size, box))
{
}

auto VoxelField::with_lattice(auto&& use) const
{
    if (!lattice_.empty()) return use(std::span<const float>(lattice_));
    if (!blurred_.empty()) return use(std::span<const float>(blurred_));
    return std::visit([&](const auto& samples) { return use(std::span(samples)); }, grid_->samples);
}

LevelMesh VoxelField::level(double value, LevelAccuracy accuracy) const
{
    const auto at = static_cast<float>(grid_->sample(value));
    return with_lattice([&](auto values) { return level_mesh(field_, values, at, accuracy); });
}

std::vector<LevelMesh> VoxelField::nearby_levels(double value) const
{
    constexpr float share = 0.02f;
    const FieldHulls::Range all = hulls_.whole();
    const auto at = static_cast<float>(grid_->sample(value));
    std::vector<LevelMesh> out;
    for (const float step : {-share, share})
        out.push_back(with_lattice([&](auto values) {
            return level_mesh(field_, values, at + step * (all.greatest - all.least),
                              LevelAccuracy::quick);
        }));
    return out;
}

LevelSide VoxelField::side(LevelSide of_values) const
{
    return (of_values == LevelSide::above) == (grid_->slope > 0) ? LevelSide::above
                                                                 : LevelSide::below;
}

Mesh VoxelField::surface(const LevelMesh& level, LevelSide of_values,
                         const glm::dmat4& to_space) const
{
    return with_lattice([&](auto values) {
        return level_surface(level, values, grid_->size, side(of_values), to_space);
    });
}

std::size_t VoxelField::bytes() const
{
    return grid_->bytes() + field_.bytes() + hulls_.bytes() +
           (blurred_.size() + lattice_.size()) * sizeof(float);
}

} // namespace trivar

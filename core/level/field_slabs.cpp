// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/field_slabs.h"

#include "core/base/rejected.h"
#include "core/field/blur.h"

#include <algorithm>
#include <fmt/format.h>
#include <type_traits>

namespace trivar {
namespace {

constexpr int layer_slices = 8; // slices of the bricks of a level
constexpr int numbering = 9;    // slices behind a slab of which its level's mesh is made, too
constexpr int near_slices = 1;  // beyond a slab in which its body is looked at

bool needs_lattice(const VoxelFieldOptions& options)
{
    return options.spline != FieldSpline::interpolating && options.order != FieldOrder::linear;
}

// The slices that a filter of the samples reaches over, as whole layers.
int blur_reach(const VoxelFieldOptions& options)
{
    return (options.blur + layer_slices - 1) / layer_slices * layer_slices;
}

std::size_t of_slice(const glm::ivec3& size)
{
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

glm::ivec3 held_size(const VoxelGrid::Samples& samples, const glm::ivec3& size)
{
    const std::size_t count = std::visit([](const auto& all) { return all.size(); }, samples);
    return {size.x, size.y, static_cast<int>(count / of_slice(size))};
}

std::vector<float> blurred_slab(const VoxelGrid::Samples& samples, const glm::ivec3& size, int blur)
{
    if (blur <= 0) return {};
    return std::visit(
        [&](const auto& all) { return blurred(std::span(all), held_size(samples, size), blur); },
        samples);
}

ScalarField<float> slab_field(const VoxelGrid::Samples& samples, const std::vector<float>& blurred,
                              const glm::ivec3& size, int held, const VoxelFieldOptions& options)
{
    const auto of = [&](const auto& all) {
        return ScalarField<float>(std::span(all), size, held, options.spline, options.order);
    };
    return blurred.empty() ? std::visit(of, samples) : of(blurred);
}

} // namespace

std::uint64_t field_bytes(std::size_t bytes_per_sample, const VoxelFieldOptions& options)
{
    constexpr std::uint64_t of_float = sizeof(float), of_hulls = 1;
    return bytes_per_sample + of_float + of_hulls + (options.blur > 0 ? 2 * of_float : 0) +
           (needs_lattice(options) ? of_float : 0);
}

int slab_halo(const VoxelFieldOptions& options)
{
    return 32 + blur_reach(options);
}

SlabPlan slab_plan(const glm::ivec3& size, std::size_t bytes_per_sample,
                   const VoxelFieldOptions& options, std::uint64_t memory_bytes)
{
    const std::uint64_t per_slice = field_bytes(bytes_per_sample, options) * of_slice(size + 2);
    const auto at_most = static_cast<std::int64_t>(memory_bytes / per_slice);
    std::int64_t least = 0;
    constexpr int fewer = 16; // slices, where memory is short
    for (const int halo : {slab_halo(options), slab_halo(options) - fewer}) {
        least = layer_slices + numbering + 2 * halo;
        if (at_most < least) continue;
        const std::int64_t fits = (at_most - numbering - 2 * halo) / layer_slices * layer_slices,
                           all = (std::int64_t{size.z} + layer_slices - 1) / layer_slices *
                                 layer_slices;
        const auto slices = static_cast<int>(std::min(fits, all));
        const std::int64_t held =
            std::min<std::int64_t>(size.z, std::int64_t{slices} + numbering + 2 * halo);
        return {size, slices, halo, per_slice * static_cast<std::uint64_t>(held)};
    }
    throw Rejected(fmt::format("{} slices of {} x {} samples, of which the level is found at a "
                               "time, take {} MB of memory, more than the {} MB allowed; allow "
                               "more, take coarser data or a box of them",
                               least, size.x, size.y,
                               per_slice * static_cast<std::uint64_t>(least) >> 20,
                               memory_bytes >> 20));
}

FieldSlab::FieldSlab(const VoxelGrid::Samples& samples, const SlabPlan& plan,
                     const VoxelFieldOptions& options, int held, int first, int end)
    : samples_(samples),
      first_(first),
      end_(end),
      blurred_(blurred_slab(samples, plan.size, options.blur)),
      field_(slab_field(samples, blurred_, plan.size, held, options)),
      hulls_(field_)
{
    if (needs_lattice(options)) lattice_ = lattice_values(field_);
}

LevelMesh FieldSlab::level(float level) const
{
    const auto of = [&](const auto& all) {
        const std::size_t slice = of_slice(field_.size()),
                          skipped = static_cast<std::size_t>(first_ - field_.first_slice()) * slice;
        const int stop = std::min(end_ + numbering, field_.size().z);
        const auto own =
            std::span(all).subspan(skipped, static_cast<std::size_t>(stop - first_) * slice);
        return level_mesh(field_, own, level, LevelAccuracy::exact, first_);
    };
    if (!lattice_.empty()) return of(lattice_);
    return blurred_.empty() ? std::visit(of, samples_) : of(blurred_);
}

LevelBody FieldSlab::body(float level, LevelSide side) const
{
    return {field_,
            hulls_,
            level,
            side,
            static_cast<float>(first_ - near_slices),
            static_cast<float>(end_ + near_slices)};
}

void for_slabs(const SlabPlan& plan, const VoxelFieldOptions& options, const SliceReader& read,
               const std::function<void(const FieldSlab&)>& use)
{
    VoxelGrid::Samples window; // of the slices from `held` on
    int held = 0, first = 0;
    const std::size_t slice_samples = of_slice(plan.size);
    const auto end_of = [&](int begin) { return std::min(begin + plan.slices, plan.size.z); };
    read([&](int, const VoxelGrid::Samples& slice) {
        if (window.index() != slice.index())
            window = std::visit(
                [](const auto& all) -> VoxelGrid::Samples {
                    return std::remove_cvref_t<decltype(all)>();
                },
                slice);
        std::visit(
            [&](auto& to) {
                const auto& from = std::get<std::remove_cvref_t<decltype(to)>>(slice);
                if (to.capacity() == 0)
                    to.reserve(slice_samples *
                               static_cast<std::size_t>(
                                   std::min(plan.size.z, plan.slices + numbering + 2 * plan.halo)));
                to.insert(to.end(), from.begin(), from.end());
            },
            window);
        while (first < plan.size.z) {
            const int end = end_of(first),
                      stop = std::min(end + numbering + plan.halo, plan.size.z);
            if (held + held_size(window, plan.size).z < stop) return;
            use(FieldSlab(window, plan, options, held, first, end));
            first = end;
            const int next = std::max(0, first - plan.halo);
            std::visit(
                [&](auto& all) {
                    all.erase(all.begin(),
                              all.begin() +
                                  static_cast<std::ptrdiff_t>(
                                      slice_samples * static_cast<std::size_t>(next - held)));
                },
                window);
            held = next;
        }
    });
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_summary.h"

#include "core/base/parallel.h"
#include "core/voxels/sample_type.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr std::size_t samples_a_part = std::size_t{1} << 20;
constexpr double bins = 256;

struct SampleRange {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
    std::size_t not_finite = 0;
};

template <class T> SampleRange range_of(const std::vector<T>& samples)
{
    std::vector<SampleRange> parts(samples.size() / samples_a_part + 1);
    parallel_blocks(samples.size(), samples_a_part, [&](std::size_t begin, std::size_t end) {
        SampleRange& part = parts[begin / samples_a_part];
        for (std::size_t i = begin; i < end; ++i) {
            const auto sample = static_cast<double>(samples[i]);
            if (!std::isfinite(sample)) {
                part.not_finite += 1;
                continue;
            }
            part.least = std::min(part.least, sample);
            part.greatest = std::max(part.greatest, sample);
        }
    });
    SampleRange all;
    for (const SampleRange& part : parts) {
        all.least = std::min(all.least, part.least);
        all.greatest = std::max(all.greatest, part.greatest);
        all.not_finite += part.not_finite;
    }
    return all;
}

template <class T>
std::array<std::uint64_t, 256> histogram_of(const std::vector<T>& samples, const SampleRange& range)
{
    using Counts = std::array<std::uint64_t, 256>;
    std::vector<Counts> parts(samples.size() / samples_a_part + 1, Counts{});
    const double width = range.greatest - range.least, scale = width > 0 ? bins / width : 0;
    parallel_blocks(samples.size(), samples_a_part, [&](std::size_t begin, std::size_t end) {
        Counts& part = parts[begin / samples_a_part];
        for (std::size_t i = begin; i < end; ++i) {
            const auto sample = static_cast<double>(samples[i]);
            if (!std::isfinite(sample)) continue;
            const double bin = std::clamp((sample - range.least) * scale, 0.0, bins - 1);
            part[static_cast<std::size_t>(bin)] += 1;
        }
    });
    Counts all{};
    for (const Counts& part : parts)
        for (std::size_t bin = 0; bin < all.size(); ++bin) all[bin] += part[bin];
    return all;
}

} // namespace

VolumeSummary summary_of(const VoxelGrid& grid)
{
    constexpr double millimetres_per_metre = 1000;
    VolumeSummary summary;
    summary.size = grid.size;
    summary.bytes = grid.bytes();
    constexpr SampleType types[] = {SampleType::u8, SampleType::i8, SampleType::u16,
                                    SampleType::i16, SampleType::f32};
    summary.type = words_of(types[grid.samples.index()]);
    for (int k = 0; k < 3; ++k)
        summary.spacing_mm[k] = millimetres_per_metre * glm::length(glm::dvec3(grid.to_metres[k]));
    std::visit(
        [&](const auto& samples) {
            const SampleRange range = range_of(samples);
            summary.not_finite = range.not_finite;
            if (range.not_finite == samples.size()) return;
            summary.least = grid.value(range.least);
            summary.greatest = grid.value(range.greatest);
            summary.histogram = histogram_of(samples, range);
        },
        grid.samples);
    if (grid.slope < 0) {
        std::swap(summary.least, summary.greatest);
        std::ranges::reverse(summary.histogram);
    }
    return summary;
}

} // namespace trivar

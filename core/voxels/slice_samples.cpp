// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/slice_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <span>
#include <type_traits>

namespace trivar {
namespace {

template <class T> T between(T low, T high, double share)
{
    const double value =
        static_cast<double>(low) + share * (static_cast<double>(high) - static_cast<double>(low));
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(std::lround(value));
    else
        return static_cast<T>(value);
}

VoxelGrid::Samples slice_between(const VoxelGrid::Samples& low, const VoxelGrid::Samples& high,
                                 double share)
{
    return std::visit(
        [&](const auto& a) -> VoxelGrid::Samples {
            auto out = a;
            const auto& b = std::get<std::remove_cvref_t<decltype(a)>>(high);
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = between(a[i], b[i], share);
            return out;
        },
        low);
}

// A slice of the grid: the number of the slice that it begins at, of the one that follows, and the
// share of that.
struct Mixed {
    std::size_t low, high;
    double share;
};

Mixed mixed(const SliceOrder& order, std::size_t slice)
{
    const auto below = static_cast<std::size_t>(order.at[slice]);
    const double share = order.at[slice] - static_cast<double>(below);
    const std::size_t low = order.order[below];
    return {low, share == 0 ? low : order.order[below + 1], share};
}

} // namespace

SliceSamples::SliceSamples(const std::vector<PlacedSlice>& slices,
                           const std::vector<std::size_t>& first, SampleType type,
                           std::size_t per_slice)
    : slices_(slices),
      first_(first),
      type_(type),
      per_slice_(per_slice),
      slope_(slices[0].frame.slope),
      intercept_(slices[0].frame.intercept)
{
    alike_ = std::ranges::all_of(slices, [&](const PlacedSlice& each) {
        return each.frame.slope == slope_ && each.frame.intercept == intercept_;
    });
    if (!alike_) {
        slope_ = 1;
        intercept_ = 0;
    }
}

std::size_t SliceSamples::file_of(std::size_t slice) const
{
    return static_cast<std::size_t>(std::ranges::upper_bound(first_, slice) - first_.begin()) - 1;
}

// The samples of a slice, of those of its file.
VoxelGrid::Samples SliceSamples::values(std::size_t slice, const VoxelGrid::Samples& of_file) const
{
    const std::size_t begin = (slice - first_[file_of(slice)]) * per_slice_;
    return std::visit(
        [&](const auto& all) -> VoxelGrid::Samples {
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(begin);
            const std::span own(from, per_slice_);
            if (alike_) return std::remove_cvref_t<decltype(all)>(own.begin(), own.end());
            const DicomFrame& frame = slices_[slice].frame;
            std::vector<float> out;
            out.reserve(per_slice_);
            for (const auto sample : own)
                out.push_back(static_cast<float>(frame.slope * static_cast<double>(sample) +
                                                 frame.intercept));
            return out;
        },
        of_file);
}

void SliceSamples::for_slices(const SliceOrder& order,
                              const std::function<bool(std::size_t)>& wanted,
                              const std::function<VoxelGrid::Samples(std::size_t file)>& decode,
                              const std::function<void(const VoxelGrid::Samples&)>& take)
{
    std::vector<std::size_t> last(first_.size(), 0); // slice of the grid that needs it, by file
    for (std::size_t k = 0; k < order.at.size(); ++k)
        if (wanted(k))
            for (const std::size_t slice : {mixed(order, k).low, mixed(order, k).high})
                last[file_of(slice)] = k;
    std::map<std::size_t, VoxelGrid::Samples> decoded; // by file
    const auto values_of = [&](std::size_t slice) {
        const std::size_t file = file_of(slice);
        auto known = decoded.find(file);
        if (known == decoded.end()) known = decoded.emplace(file, decode(file)).first;
        return values(slice, known->second);
    };
    for (std::size_t k = 0; k < order.at.size(); ++k) {
        if (!wanted(k)) continue;
        const Mixed mix = mixed(order, k);
        VoxelGrid::Samples slice = values_of(mix.low);
        if (mix.share != 0) slice = slice_between(slice, values_of(mix.high), mix.share);
        take(slice);
        std::erase_if(decoded, [&](const auto& each) { return last[each.first] <= k; });
    }
}

} // namespace trivar

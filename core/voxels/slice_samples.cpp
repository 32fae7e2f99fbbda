// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/slice_samples.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <type_traits>

namespace trivar {
namespace {

VoxelGrid::Samples samples_for(SampleType type, std::size_t count)
{
    switch (type) {
    case SampleType::u8: return std::vector<std::uint8_t>(count);
    case SampleType::i8: return std::vector<std::int8_t>(count);
    case SampleType::u16: return std::vector<std::uint16_t>(count);
    case SampleType::i16: return std::vector<std::int16_t>(count);
    default: return std::vector<float>(count);
    }
}

template <class T> T between(T low, T high, double share)
{
    const double value =
        static_cast<double>(low) + share * (static_cast<double>(high) - static_cast<double>(low));
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(std::lround(value));
    else
        return static_cast<T>(value);
}

} // namespace

SliceSamples::SliceSamples(const std::vector<PlacedSlice>& slices, SampleType type,
                           std::size_t per_slice)
    : slices_(slices),
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
    samples_ = samples_for(alike_ ? type : SampleType::f32, per_slice * slices.size());
}

void SliceSamples::put(std::size_t first, const VoxelGrid::Samples& samples)
{
    std::visit(
        [&](auto& to, const auto& from) {
            using To = std::ranges::range_value_t<decltype(to)>;
            using From = std::ranges::range_value_t<decltype(from)>;
            const std::size_t begin = first * per_slice_;
            if constexpr (std::is_same_v<To, From>)
                if (alike_) {
                    std::ranges::copy(from, to.begin() + static_cast<std::ptrdiff_t>(begin));
                    return;
                }
            if constexpr (std::is_same_v<To, float>)
                for (std::size_t i = 0; i < from.size(); ++i) {
                    const DicomFrame& frame = slices_[first + i / per_slice_].frame;
                    to[begin + i] = static_cast<float>(frame.slope * static_cast<double>(from[i]) +
                                                       frame.intercept);
                }
        },
        samples_, samples);
}

VoxelGrid::Samples SliceSamples::ordered(const SliceOrder& order)
{
    return std::visit(
        [&](auto& from) -> VoxelGrid::Samples {
            using T = std::ranges::range_value_t<decltype(from)>;
            std::vector<T> to(order.at.size() * per_slice_);
            parallel_blocks(order.at.size(), 1, [&](std::size_t k, std::size_t) {
                const auto below = static_cast<std::size_t>(order.at[k]);
                const double share = order.at[k] - static_cast<double>(below);
                const T* const low = from.data() + order.order[below] * per_slice_;
                T* const out = to.data() + k * per_slice_;
                if (share == 0) {
                    std::copy(low, low + per_slice_, out);
                    return;
                }
                const T* const high = from.data() + order.order[below + 1] * per_slice_;
                for (std::size_t i = 0; i < per_slice_; ++i)
                    out[i] = between(low[i], high[i], share);
            });
            from = {};
            return to;
        },
        samples_);
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/field/blur.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cstdint>

namespace trivar {
namespace {

// One pass along one axis over lines that are `count` samples of `stride`; those beside each other
// are `width` consecutive ones.
void blur_lines(float* first, std::size_t stride, std::size_t count, std::size_t width)
{
    std::vector<float> before(first + stride, first + stride + width), own(width);
    for (std::size_t i = 0; i < count; ++i) {
        float* at = first + stride * i;
        const float* after = i + 1 < count ? at + stride : nullptr;
        std::copy_n(at, width, own.begin());
        const float* next = after ? after : before.data();
        for (std::size_t x = 0; x < width; ++x)
            at[x] = 0.25f * before[x] + 0.5f * own[x] + 0.25f * next[x];
        before.swap(own);
    }
}

} // namespace

template <class Sample>
std::vector<float> blurred(std::span<const Sample> samples, const glm::ivec3& size,
                           const glm::ivec3& times)
{
    const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y),
               depth = static_cast<std::size_t>(size.z), plane = width * height;
    std::vector<float> out(samples.begin(), samples.end());
    for (int n = 0; n < std::max({times.x, times.y, times.z}); ++n) {
        if (n < times.x || n < times.y)
            parallel_blocks(depth, 1, [&](std::size_t k, std::size_t) {
                for (std::size_t j = 0; n < times.x && j < height; ++j)
                    blur_lines(out.data() + plane * k + width * j, 1, width, 1);
                if (n < times.y) blur_lines(out.data() + plane * k, width, height, width);
            });
        if (n < times.z)
            parallel_blocks(height, 4, [&](std::size_t begin, std::size_t end) {
                for (std::size_t j = begin; j < end; ++j)
                    blur_lines(out.data() + width * j, plane, depth, width);
            });
    }
    return out;
}

#define TRIVAR_BLUR_OF(Sample)                                                      \
    template std::vector<float> blurred(std::span<const Sample>, const glm::ivec3&, \
                                        const glm::ivec3&);
TRIVAR_BLUR_OF(std::uint8_t)
TRIVAR_BLUR_OF(std::int8_t)
TRIVAR_BLUR_OF(std::uint16_t)
TRIVAR_BLUR_OF(std::int16_t)
TRIVAR_BLUR_OF(float)
#undef TRIVAR_BLUR_OF

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// LatticeSigns says of every sample whether it is at least a level, in one bit each. A sample equal
// to the level is inside; one that is not a number is not.
class LatticeSigns {
public:
    static constexpr int brick = 8; // samples along each axis

    template <class Sample>
    LatticeSigns(std::span<const Sample> samples, const glm::ivec3& size, float level)
        : size_(size),
          row_(static_cast<std::size_t>(size.x + 7) / 8 + 2),
          bits_(row_ * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z))
    {
        const auto width = static_cast<std::size_t>(size.x);
        parallel_blocks(samples.size() / width, 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t r = begin; r < end; ++r) {
                const Sample* s = samples.data() + width * r;
                std::uint8_t* to = bits_.data() + row_ * r;
                std::size_t i = 0;
                for (; i + 8 <= width; i += 8) {
                    unsigned byte = 0;
                    for (unsigned e = 0; e < 8; ++e)
                        byte |= unsigned{static_cast<float>(s[i + e]) >= level} << e;
                    to[i / 8] = static_cast<std::uint8_t>(byte);
                }
                unsigned byte = 0;
                for (std::size_t e = 0; i + e < width; ++e)
                    byte |= unsigned{static_cast<float>(s[i + e]) >= level} << e;
                if (i < width) to[i / 8] = static_cast<std::uint8_t>(byte);
            }
        });
    }

    // The bits of the eight samples of a row in a brick, and of the eight after these; a row beyond
    // the last is the last.
    unsigned row(int y, int z, int brick_x) const
    {
        const std::size_t r =
            static_cast<std::size_t>(std::min(y, size_.y - 1)) +
            static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(std::min(z, size_.z - 1));
        std::uint16_t two;
        std::memcpy(&two, bits_.data() + row_ * r + static_cast<std::size_t>(brick_x), 2);
        return two;
    }
    // The bits that are samples of a row in a brick: nine, and fewer at the grid's end.
    unsigned mask(int brick_x) const
    {
        return brick * (brick_x + 1) < size_.x ? 0x1FF : (1u << (size_.x - brick * brick_x)) - 1;
    }
    const glm::ivec3& size() const { return size_; }
    glm::ivec3 bricks() const { return (size_ + brick - 1) / brick; }

private:
    glm::ivec3 size_;
    std::size_t row_; // bytes, with two to spare
    std::vector<std::uint8_t> bits_;
};

} // namespace trivar

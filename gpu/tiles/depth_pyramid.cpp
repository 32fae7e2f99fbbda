// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/depth_pyramid.h"

#include <algorithm>

namespace trivar::gpu {

DepthPyramid::DepthPyramid(std::vector<float> depths, glm::ivec2 size_px)
    : size_px_(size_px),
      depths_(std::move(depths))
{
    depths_.reserve(depths_.size() * 3 / 2 + 64);
    std::size_t begin = 0;
    for (glm::ivec2 fine = size_px; glm::any(glm::greaterThan(fine, glm::ivec2(1)));) {
        const glm::ivec2 coarse = (fine + 1) / 2, last = fine - 1;
        const auto at = [&](int x, int y) {
            return depths_[begin + static_cast<std::size_t>(y * fine.x + x)];
        };
        for (int y = 0; y < coarse.y; ++y)
            for (int x = 0; x < coarse.x; ++x) {
                const glm::ivec2 lo = 2 * glm::ivec2(x, y), hi = glm::min(lo + 1, last);
                depths_.push_back(
                    std::max({at(lo.x, lo.y), at(hi.x, lo.y), at(lo.x, hi.y), at(hi.x, hi.y)}));
            }
        begin += static_cast<std::size_t>(fine.x) * static_cast<std::size_t>(fine.y);
        fine = coarse;
    }
}

} // namespace trivar::gpu

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar::gpu {

// A DepthPyramid holds the depths of a picture, and in each smaller level the greatest of four of
// them, to find boxes behind them [Greene, Kass, Miller 1993]. A level has half of the texels of
// the one before along each side, rounded up; the last has one.
class DepthPyramid {
public:
    DepthPyramid() = default;
    // `depths` are those of a depth buffer, 0..1, the lowest row first. O(#depths).
    DepthPyramid(std::vector<float> depths, glm::ivec2 size_px);

    glm::ivec2 size_px() const { return size_px_; }           // of the picture; 0: there is none
    std::span<const float> depths() const { return depths_; } // level by level, row by row

private:
    glm::ivec2 size_px_{0};
    std::vector<float> depths_;
};

} // namespace trivar::gpu

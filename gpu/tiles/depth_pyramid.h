// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <vector>

namespace trivar::gpu {

// A DepthPyramid tells what lies behind what a picture shows: it holds the depths of the picture,
// and in each smaller level the greatest of four of them [Greene, Kass, Miller 1993].
class DepthPyramid {
public:
    DepthPyramid() = default;
    // `depths` are those of a depth buffer, 0..1, the lowest row first. O(#depths).
    DepthPyramid(std::vector<float> depths, glm::ivec2 size_px);

    // Whether what lies in a box cannot be seen, where `to_clip` takes its space to clip space:
    // all that is drawn over its place in the picture, and a texel round it, is nearer than its
    // nearest corner. False where the box reaches behind the camera. About 0.1 microseconds.
    bool hides(const Box& box, const glm::dmat4& to_clip) const;

private:
    struct Level {
        glm::ivec2 size_px{0};
        std::vector<float> depths;
        float at(glm::ivec2 p_px) const
        {
            return depths[static_cast<std::size_t>(p_px.y) * static_cast<std::size_t>(size_px.x) +
                          static_cast<std::size_t>(p_px.x)];
        }
    };
    std::vector<Level> levels_;
};

} // namespace trivar::gpu

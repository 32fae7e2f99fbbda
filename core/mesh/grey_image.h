// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A picture as numbers: what a mask or a height reads. Rows from the top.
struct GreyImage {
    glm::ivec2 size_px{0};
    std::vector<float> values;  // width x height, finite
    std::size_t no_numbers = 0; // of pixels that were none in the file, and count as 0
};

// The continuation of a picture beyond its borders.
enum class ImageEdge {
    repeat, // it begins again
    stay    // as its border
};

// The value at a point of the picture, bilinear between the middles of pixels: (0, 0) is its lower
// left corner and (1, 1) its upper right one. 0 for an empty picture or no number.
inline double grey_at(const GreyImage& image, const glm::dvec2& uv, ImageEdge edge)
{
    if (image.values.empty() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return 0;
    struct Between { // two pixels
        std::size_t a, b;
        double share; // of the second one
    };
    const auto between = [edge](double t, int count) -> Between {
        if (edge == ImageEdge::repeat) t -= std::floor(t);
        const double at = std::clamp(t, 0.0, 1.0) * count - 0.5, low = std::floor(at);
        const int first = static_cast<int>(low), last = count - 1;
        const auto pixel = [&](int k) {
            if (edge == ImageEdge::repeat) k = k < 0 ? last : k > last ? 0 : k;
            return static_cast<std::size_t>(std::clamp(k, 0, last));
        };
        return {pixel(first), pixel(first + 1), at - low};
    };
    const Between x = between(uv.x, image.size_px.x), y = between(1 - uv.y, image.size_px.y);
    const auto value = [&](std::size_t i, std::size_t j) {
        return static_cast<double>(image.values[j * static_cast<std::size_t>(image.size_px.x) + i]);
    };
    const auto row = [&](std::size_t j) {
        return (1 - x.share) * value(x.a, j) + x.share * value(x.b, j);
    };
    return (1 - y.share) * row(y.a) + y.share * row(y.b);
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/stroke.h"
#include "core/silhouette/silhouettes.h"

#include <span>

namespace trivar {

// Curves in an image: those of silhouettes, by the same numbers.
struct ImageCurves {
    std::vector<StrokePoint> points;
    std::span<const std::uint32_t> first;
    std::span<const char> closed;
    // The point after another; none at the end of an open curve.
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    std::vector<std::uint32_t> next;
};
ImageCurves in_image(const Silhouettes& silhouettes, const glm::dmat4& to_image);

// A LineMark is a place where a line may begin or cease to be hidden: where one that is nearer to
// the eye crosses it in the image, or at a cusp, where its bend changes its sign.
struct LineMark {
    std::uint32_t point; // before it
    float share;         // of the way to the next point
};
// All of them, in order. O(n log n) for curves that cross each other O(n) times.
std::vector<LineMark> line_marks(const ImageCurves& curves);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/loops.h"

#include <algorithm>

namespace trivar {

// A PlaneGrid is the grid of whole numbers over points between `lo` and `hi`, as fine as numbers up
// to most_units allow, with a margin of eight. Whatever the size and the place of the points, and
// whatever a number is, no place of the grid is beyond that: points that double precision can
// hardly tell apart fall together.
struct PlaneGrid {
    glm::dvec2 middle{0};
    double size = 0, scale = 0; // of the longer side; units of the grid per unit of the points

    PlaneGrid(const glm::dvec2& lo, const glm::dvec2& hi)
        : middle((lo + hi) / 2.0),
          size(std::max({1e-300, hi.x - lo.x, hi.y - lo.y})),
          scale(2 * farthest / size)
    {
    }
    glm::ivec2 at(const glm::dvec2& p) const
    {
        const glm::dvec2 far(farthest); // in this order what is no number is at the low end
        return glm::ivec2(glm::min(far, glm::max(-far, glm::round((p - middle) * scale))));
    }
    glm::dvec2 point(const glm::ivec2& p) const { return middle + glm::dvec2(p) / scale; }

    static constexpr double farthest = most_units - 8;
};

} // namespace trivar

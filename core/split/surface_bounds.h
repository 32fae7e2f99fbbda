// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

#include <algorithm>
#include <cmath>

namespace trivar {

// Bounds of the absolute values of a function of (v, w) and of its derivatives.
struct JetBound {
    double value = 0, v = 0, w = 0, vv = 0, vw = 0, ww = 0;

    void add(const JetBound& other) // afterwards it bounds both
    {
        value = std::max(value, other.value);
        v = std::max(v, other.v);
        w = std::max(w, other.w);
        vv = std::max(vv, other.vv);
        vw = std::max(vw, other.vw);
        ww = std::max(ww, other.ww);
    }
    // of the first and second derivative along a direction
    double first(const glm::dvec2& e) const { return v * std::abs(e.x) + w * std::abs(e.y); }
    double second(const glm::dvec2& e) const
    {
        return vv * e.x * e.x + 2 * vw * std::abs(e.x * e.y) + ww * e.y * e.y;
    }
};

// SurfaceBounds bounds a bicubic spline with equally spaced knots over rectangles: the Bezier
// points of each of its pieces, and their differences, bound the piece and its derivatives (convex
// hull). Beyond the domain the function is taken as all zero, or as what it is at the border.
class SurfaceBounds {
public:
    explicit SurfaceBounds(const Surface<double>& surface, bool zero_outside);
    JetBound over(const glm::dvec2& lo, const glm::dvec2& hi) const; // O(#pieces touched)

private:
    glm::dvec2 lo_{0}, hi_{0}, per_cell_{1}; // per_cell_: 1 / length of a piece
    glm::ivec2 count_{0};
    std::vector<JetBound> cells_; // w fastest
    bool zero_outside_;
};

} // namespace trivar

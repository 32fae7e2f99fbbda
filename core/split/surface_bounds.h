// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

#include <algorithm>
#include <cmath>
#include <span>

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
    friend class BendBounds;
    struct Cells { // a rectangle of pieces
        glm::ivec2 from, to;
    };
    Cells cells(const glm::dvec2& lo, const glm::dvec2& hi) const;
    bool is_outside(const glm::dvec2& lo, const glm::dvec2& hi) const;

    glm::dvec2 lo_{0}, hi_{0}, per_cell_{1}; // per_cell_: 1 / length of a piece
    glm::ivec2 count_{0};
    std::vector<JetBound> cells_; // w fastest
    bool zero_outside_;
};

// BendBounds bounds the second derivatives of several such splines with the same knots, over
// rectangles of any size in O(1): it knows the greatest of all 2^p x 2^q pieces side by side.
class BendBounds {
public:
    struct Bend {
        double vv = 0, vw = 0, ww = 0;
        double second(const glm::dvec2& e) const // along a direction
        {
            return vv * e.x * e.x + 2 * vw * std::abs(e.x * e.y) + ww * e.y * e.y;
        }
    };
    explicit BendBounds(std::span<const SurfaceBounds> surfaces);
    Bend over(const glm::dvec2& lo, const glm::dvec2& hi) const;

private:
    const Bend& most(int p, int q, int i, int j) const // of pieces from (i, j)
    {
        const glm::ivec2& count = grid_.count_;
        return most_[static_cast<std::size_t>(((p * levels_.y + q) * count.x + i) * count.y + j)];
    }
    SurfaceBounds grid_;
    glm::ivec2 levels_{0};
    std::vector<Bend> most_; // by p, q, i, j; the last one fastest
};

} // namespace trivar

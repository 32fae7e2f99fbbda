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
    // Bounds of the first and the second derivative along a direction.
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
    // Each of its pieces is bounded in `parts` x `parts` parts.
    explicit SurfaceBounds(const Surface<double>& surface, bool zero_outside, int parts = 1);
    JetBound over(const glm::dvec2& lo, const glm::dvec2& hi) const // O(#pieces touched)
    {
        return is_outside(lo, hi) ? JetBound{} : over(cells(lo, hi));
    }
    struct Cells { // a rectangle of pieces
        int from_v, to_v, from_w, to_w;
    };
    Cells cells(const glm::dvec2& lo, const glm::dvec2& hi) const
    {
        return {cell(lo, 0, -rounding), cell(hi, 0, rounding), cell(lo, 1, -rounding),
                cell(hi, 1, rounding)};
    }
    JetBound over(const Cells& cells) const
    {
        JetBound out = cells_[static_cast<std::size_t>(cells.from_v * count_.y + cells.from_w)];
        if (cells.from_v == cells.to_v && cells.from_w == cells.to_w) return out;
        for (int i = cells.from_v; i <= cells.to_v; ++i)
            for (int j = cells.from_w; j <= cells.to_w; ++j)
                out.add(cells_[static_cast<std::size_t>(i * count_.y + j)]);
        return out;
    }

private:
    friend class BendBounds;
    // Both pieces count at the border between them, where rounding decides.
    static constexpr double rounding = 1e-9;
    int cell(const glm::dvec2& at, int axis, double more) const
    {
        const double place = (at[axis] - lo_[axis]) * per_cell_[axis] + more;
        return static_cast<int>(std::min(std::max(place, 0.0), count_[axis] - 1.0));
    }
    bool is_outside(const glm::dvec2& lo, const glm::dvec2& hi) const
    {
        return zero_outside_ && (hi.x <= lo_.x || hi.y <= lo_.y || lo.x >= hi_.x || lo.y >= hi_.y);
    }

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

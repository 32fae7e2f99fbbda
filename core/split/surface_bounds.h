// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

namespace trivar {

// Bounds of the absolute values of a function of (v, w) and of its derivatives.
struct JetBound {
    double value = 0, v = 0, w = 0, vv = 0, vw = 0, ww = 0;

    void add(const JetBound& other); // afterwards it bounds both
    // of the first and second derivative along a direction
    double first(const glm::dvec2& e) const;
    double second(const glm::dvec2& e) const;
};

// SurfaceBounds bounds a bicubic spline over rectangles: the Bezier points of each of its pieces,
// and their differences, bound the piece and its derivatives (convex hull). Beyond the domain the
// function is taken as `outside`: all zero, or what it is at the border.
class SurfaceBounds {
public:
    explicit SurfaceBounds(const Surface<double>& surface, bool zero_outside);
    JetBound over(const glm::dvec2& lo, const glm::dvec2& hi) const; // O(#pieces touched)

private:
    std::array<std::vector<double>, 2> breaks_;
    std::vector<JetBound> cells_; // w fastest
    bool zero_outside_;
};

} // namespace trivar

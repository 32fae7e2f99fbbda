// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/error_bounds.h"

namespace trivar::testing {

using Corners3 = std::array<glm::dvec3, 3>;

// The greatest distance of the displacement from the linear one through the corners, over a grid
// of points with `levels` steps along each edge: never more than the truth.
inline double sampled_error(const Trivariate<glm::dvec3>& f, const Corners3& t, int levels = 16)
{
    const std::array<glm::dvec3, 3> d{evaluate(f, t[0]).value, evaluate(f, t[1]).value,
                                      evaluate(f, t[2]).value};
    double most = 0;
    for (int i = 0; i <= levels; ++i)
        for (int j = 0; i + j <= levels; ++j) {
            const double a = double(i) / levels, b = double(j) / levels, c = 1 - a - b;
            const glm::dvec3 uvw = a * t[0] + b * t[1] + c * t[2];
            most = std::max(most,
                            glm::distance(evaluate(f, uvw).value, a * d[0] + b * d[1] + c * d[2]));
        }
    return most;
}

inline std::array<ErrorBounds::Corner, 3> corners_of(const ErrorBounds& bounds, const Corners3& t)
{
    return {bounds.corner(t[0]), bounds.corner(t[1]), bounds.corner(t[2])};
}

inline ErrorBounds bounds_of(const Trivariate<glm::dvec3>& f)
{
    return ErrorBounds(std::make_shared<const DisplacementCells>(f));
}

// (0, 0, f) over [lo, hi]^3 for a function that is linear along each axis.
template <class F> Trivariate<glm::dvec3> multilinear(double lo, double hi, const F& f)
{
    const Knots knots = Knots::uniform(3, 3, lo, hi);
    Trivariate<glm::dvec3> out{{knots, knots, knots}, {}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                out.points.emplace_back(0, 0,
                                        f(knots.greville(i), knots.greville(j), knots.greville(k)));
    return out;
}

} // namespace trivar::testing

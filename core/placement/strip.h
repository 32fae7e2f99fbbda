// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/curve.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// The ruled strip round a curve in the picture: R(a, v) = C(a) + lerp(-right, left, v) N(a) for a
// and v in [0, 1], where N points to the left of the direction of travel. Schein 2006, 2.3.1.
struct Strip {
    Curve<glm::dvec2> center;
    std::vector<double> left_px, right_px; // half widths at equal steps of a, at least 2
    std::vector<char> narrowed;            // at the same steps: 1 where a bend took width away

    // The straight line across at `a`, from the right rim to the left one.
    struct Ruling {
        glm::dvec2 right, left;
        glm::dvec2 at(double v) const { return glm::mix(right, left, v); }
    };
    Ruling ruling(double a) const;
    glm::dvec2 at(double a, double v) const { return ruling(a).at(v); }
};

// A strip with the half widths asked for, given at equal steps of a. Where the curve bends tighter
// than that, the inner side is narrowed to 0.9 of the radius, and before and after it gradually,
// so that no ruling crosses another.
Strip strip_round(Curve<glm::dvec2> center, const std::vector<double>& half_width_px);

// The largest turn of the curve, in radians, within a stretch of it as long as the strip is wide.
// From pi on the strip would run back into itself. The half widths are given at equal steps of a.
double sharpest_turn(const Curve<glm::dvec2>& center, const std::vector<double>& half_width_px);

// A value given at equal steps of [0, 1], linear in between.
double profile_at(const std::vector<double>& profile, double t);

} // namespace trivar

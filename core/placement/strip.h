// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/curve.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A Strip is the ruled strip round a curve in the picture: R(a, v) = C(a) + lerp(-right, left, v)
// N(a) for a and v in [0, 1], where N points to the left of the direction of travel. Schein 2006,
// 2.3.1.
//
//     v = 1   left rim    +----+----+----+----+
//                         |    |    |    |    |     rulings: straight lines across
//             C(a)     a=0 -----------------> a=1
//                         |    |    |    |    |
//     v = 0   right rim   +----+----+----+----+
struct Strip {
    Curve<glm::dvec2> center;
    std::vector<double> left_px, right_px; // half widths at equal steps of a, at least 2
    std::vector<char> narrowed; // at the same steps: 1 where a bend of the curve narrowed the strip

    // A Ruling is the straight line across the strip at `a`, from the right rim to the left one.
    struct Ruling {
        glm::dvec2 right, left;
        glm::dvec2 at(double v) const { return glm::mix(right, left, v); }
    };
    Ruling ruling(double a) const;
    glm::dvec2 at(double a, double v) const { return ruling(a).at(v); }
};

// Makes the strip with the given half widths, at equal steps of a. Where the curve bends more
// tightly than a half width, the inner side is narrowed to 0.9 of the curve's radius, gradually
// before and after, so that no ruling crosses another.
Strip strip_round(Curve<glm::dvec2> center, const std::vector<double>& half_width_px);

// The largest turn of the curve, in radians, within a stretch that is as long as the strip is wide.
// From pi on the strip would run back into itself. The half widths are given at equal steps of a.
double sharpest_turn(const Curve<glm::dvec2>& center, const std::vector<double>& half_width_px);

// The value of a profile at t; its values are given at equal steps of [0, 1] and are linear in
// between.
double profile_at(const std::vector<double>& profile, double t);

} // namespace trivar

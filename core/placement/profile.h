// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// How a size changes along the stroke: the factor at a share of its length, as the quadratic
// B-spline curve over control points (share, factor) on uniform knots. The shares ascend from 0 to
// 1, so the curve is a function of the share, and never leaves the range of its factors. Without
// points the factor is 1 everywhere.
class Profile {
public:
    explicit Profile(const std::vector<glm::dvec2>& points = {});
    double at(double share) const; // O(log points)
    double largest() const { return largest_; }

private:
    struct Piece { // Bezier points
        glm::dvec2 a, b, c;
    };
    std::vector<Piece> pieces_;
    double largest_ = 1;
};

inline constexpr double least_profile = 0.02, most_profile = 20;
inline constexpr std::size_t most_profile_points = 64;

// Throws Rejected, naming the field, for a single point, more than 64 of them, factors beyond the
// range above, and shares that do not ascend from 0 to 1.
void check_profile(const std::vector<glm::dvec2>& points, const std::string& name);

// What a brush makes of a stroke: the same width all along, wider where the hand was slower than it
// mostly was, or twice the pressure.
enum class Brush { even, speed, pressure };
// The profile of width it draws, smooth, at most 9 points; empty where it hardly changes.
std::vector<glm::dvec2> brush_profile(const std::vector<StrokeSample>& samples, Brush brush);

} // namespace trivar

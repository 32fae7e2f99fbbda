// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// A ShareCurve is a function over [0, 1]: the quadratic B-spline curve over control points (place,
// value) on uniform knots. The places ascend from 0 to 1, so the curve is a function of the place,
// never leaves the range of its values, and ascends where they do.
class ShareCurve {
public:
    explicit ShareCurve(const std::vector<glm::dvec2>& points = {});
    bool empty() const { return pieces_.empty(); }
    double at(double place) const; // O(log #points); only with points

private:
    struct Piece { // Bezier points
        glm::dvec2 a, b, c;
    };
    std::vector<Piece> pieces_;
};

// A Profile changes a size along or across the stroke: it gives the factor at a share of the way.
// Without points it is 1 everywhere; where all points have one factor, it is exactly that factor.
class Profile {
public:
    explicit Profile(const std::vector<glm::dvec2>& points = {});
    double at(double share) const { return curve_.empty() ? even_ : curve_.at(share); }
    double largest() const { return largest_; }

private:
    ShareCurve curve_;
    double even_ = 1, largest_ = 1;
};

// A Rise says how far a volume has risen at w, from 0 to 1. It is a spline on the volume's third
// axis with the control points g(Greville abscissa), where g is the curve over the given points.
// The given points ascend strictly, and so do the control points and the rise. Without points, or
// where each value equals its place, the rise is exactly w.
class Rise {
public:
    Rise(const std::vector<glm::dvec2>& points, Knots above);
    double point(int k) const { return points_[static_cast<std::size_t>(k)]; } // control point
    double at(double w) const;
    double w_at(double risen) const; // the inverse of at()

private:
    Knots above_;
    std::vector<double> points_;
    bool itself_;
};

inline constexpr double least_profile = 0.02, most_profile = 20;
inline constexpr double least_rise = 1e-3; // from one point to the next
inline constexpr std::size_t most_profile_points = 64;

// Throws Rejected, naming the field, for a single point, more than 64 points, factors outside the
// range above, and shares that do not ascend from 0 to 1.
void check_profile(const std::vector<glm::dvec2>& points, const std::string& name);
// The same for a rise, whose values must ascend strictly from 0 to 1.
void check_rise(const std::vector<glm::dvec2>& points, const std::string& name);

// A Brush decides a stroke's width: even; wider where the hand was slower than its usual speed; or
// twice the pressure.
enum class Brush { even, speed, pressure };
// The smooth profile of width that a brush draws, at most 9 points; empty where the width hardly
// changes.
std::vector<glm::dvec2> brush_profile(const std::vector<StrokeSample>& samples, Brush brush);

} // namespace trivar

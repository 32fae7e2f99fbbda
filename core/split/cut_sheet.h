// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cutting.h"

#include <array>
#include <string>

namespace trivar {

// Returns a sentence that says why the points are no stroke of a cut: it turns back over its chord,
// or has one point. Empty: they are one.
std::string stroke_trouble(const std::vector<glm::dvec2>& stroke);

// A CutSheet is the surface u = phi(v, w) of a plain cut over its plane, in a frame whose u is the
// normal, whose v goes along the stroke and whose w goes away from the eye. With a curve u = f(v)
// and q = 1 + w / eye,
//
//   phi(v, w) = q f(v / q),
//
//                         . |      the cone from the eye over the curve: f at w = 0,
//                 . |       |      twice as large at w = eye; f(v) everywhere without an
//      eye *      f |    2f |      eye, 0 without a stroke
//         -eye     0      eye --> w
//
// f is the cubic through the points whose slopes are those of the parabolas through three of them,
// and straight beyond its ends; so it is smooth, and its second derivative is known.
class CutSheet {
public:
    // `to_own` takes points of the mesh that is cut to the space of the cut; it may mirror.
    CutSheet(const PlainCut& cut, const glm::dmat4& to_own);

    bool is_flat() const { return points_.empty(); }
    glm::dvec3 uvw(const glm::dvec3& p) const { return to_uvw_ * glm::dvec4(p, 1); }
    glm::dvec3 point(const glm::dvec2& vw) const;  // of the surface, in the mesh's space
    glm::dvec3 normal(const glm::dvec2& vw) const; // unit, there; points to what is above
    double height(const glm::dvec3& uvw) const { return uvw.x - phi({uvw.y, uvw.z}); }
    double phi(const glm::dvec2& vw) const;
    // Bounds of |second derivative of phi along e| |e|^2 over a triangle of (v, w), for its edges e
    // (corner i to the next). O(log #points + #points over the triangle).
    std::array<double, 3> bends(const std::array<glm::dvec2, 3>& vw) const;

private:
    struct Slope {
        double value, slope;
    };
    double q(double w) const;
    Slope curve(double v) const;
    double most_bent(double lo, double hi) const; // bound of |f''| there

    glm::dmat4 to_uvw_, from_uvw_;
    double eye_ = 0;
    std::vector<glm::dvec2> points_;
    std::vector<double> slopes_; // at the points
    std::vector<double> bent_;   // between two points: the most of |f''|
};

} // namespace trivar

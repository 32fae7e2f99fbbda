// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/runs.h"

namespace trivar {

// A SlitCurve is a run as a polyline in space, with the direction to its left at each point: across
// the cut and along the skin, unit, or shorter where there is none (a spur).
class SlitCurve {
public:
    SlitCurve(const SlitRun& run, const SlitDrawing& drawing, const Inward& inward);

    struct Foot {
        std::size_t segment;
        double s, distance;
    };
    // The foot of a point, by descent from a segment near it, among the segments first to last.
    Foot foot(const glm::dvec3& p, std::size_t from, std::size_t first, std::size_t last) const;
    std::size_t segment_at(double s) const;
    std::size_t segment_count() const { return s_.size() - 1; }
    double s(std::size_t i) const { return s_[i]; }
    glm::dvec3 point(double s, std::size_t segment) const { return mixed(points_, s, segment); }
    glm::dvec3 left(double s, std::size_t segment) const { return mixed(left_, s, segment); }
    glm::dvec3 up(double s, std::size_t segment) const { return mixed(up_, s, segment); }
    glm::dvec3 point(double s) const { return point(s, segment_at(s)); }
    glm::dvec3 left(double s) const { return left(s, segment_at(s)); }

    double share(double s, std::size_t segment) const; // of the segment, at s

private:
    glm::dvec3 mixed(const std::vector<glm::dvec3>& values, double s, std::size_t segment) const;
    Foot foot_on(const glm::dvec3& p, std::size_t segment) const;

    std::vector<double> s_;
    std::vector<glm::dvec3> points_, left_, up_; // up: out of the skin, unit
};

} // namespace trivar

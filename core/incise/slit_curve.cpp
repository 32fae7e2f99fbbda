// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/slit_curve.h"

#include "core/base/share_along.h"
#include "core/base/unit.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr double edges_of_window = 1.5, share_of_window = 0.04, widths_of_window = 1.5;
constexpr double well_left = 0.3, hardly_left = 0.1; // cosines with the left of both neighbours
constexpr int most_misses = 3; // segments further away than the best, before a descent ends

} // namespace

SlitCurve::SlitCurve(const SlitRun& run, const SlitDrawing& drawing, const Inward& inward)
{
    for (const SlitRun::At& at : run.at) {
        s_.push_back(at.s);
        points_.push_back(drawing.position(at.point));
        up_.push_back(unit_or_zero(inward.outward(drawing.point(at.point))));
    }
    const double window = std::max({edges_of_window * drawing.skin().usual_edge(),
                                    share_of_window * run.length, widths_of_window * run.width});
    const std::size_t last = s_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const auto left_of = [&](const glm::dvec3& along) {
            return unit_or_zero(glm::cross(up_[i], along));
        };
        const glm::dvec3 l1 =
            left_of(i > 0 ? points_[i] - points_[i - 1] : points_[1] - points_[0]);
        const glm::dvec3 l2 =
            left_of(i < last ? points_[i + 1] - points_[i] : points_[last] - points_[last - 1]);
        const auto leftness = [&](const glm::dvec3& v) {
            return std::min(glm::dot(v, l1), glm::dot(v, l2));
        };
        glm::dvec3 left = left_of(point(s_[i] + window) - point(s_[i] - window));
        if (leftness(left) < well_left) {
            left = unit_or_zero(l1 + l2);
            const double fit = leftness(left);
            if (fit < well_left)
                left *= std::max(0.0, (fit - hardly_left) / (well_left - hardly_left));
        }
        left_.push_back(left);
    }
}

std::size_t SlitCurve::segment_at(double s) const
{
    const auto next = std::ranges::upper_bound(s_, s) - s_.begin();
    return static_cast<std::size_t>(
               std::clamp<std::ptrdiff_t>(next, 1, static_cast<std::ptrdiff_t>(s_.size()) - 1)) -
           1;
}

double SlitCurve::share(double s, std::size_t segment) const
{
    const double length = s_[segment + 1] - s_[segment];
    return length > 0 ? std::clamp((s - s_[segment]) / length, 0.0, 1.0) : 0;
}

glm::dvec3 SlitCurve::mixed(const std::vector<glm::dvec3>& values, double s,
                            std::size_t segment) const
{
    const double t = share(s, segment);
    return (1 - t) * values[segment] + t * values[segment + 1];
}

SlitCurve::Foot SlitCurve::foot_on(const glm::dvec3& p, std::size_t segment) const
{
    const glm::dvec3 a = points_[segment], d = points_[segment + 1] - a;
    const double t = share_along(p, a, d);
    return {segment, s_[segment] + t * (s_[segment + 1] - s_[segment]),
            glm::distance(p, a + t * d)};
}

SlitCurve::Foot SlitCurve::foot(const glm::dvec3& p, std::size_t from, std::size_t first,
                                std::size_t last) const
{
    Foot best = foot_on(p, from);
    for (const bool up : {false, true}) {
        int misses = 0;
        for (std::size_t i = from; misses < most_misses && (up ? i < last : i > first);) {
            i = up ? i + 1 : i - 1;
            const Foot other = foot_on(p, i);
            misses = other.distance < best.distance ? 0 : misses + 1;
            if (misses == 0) best = other;
        }
    }
    return best;
}

} // namespace trivar

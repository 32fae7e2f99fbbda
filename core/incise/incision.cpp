// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incision.h"

#include "core/base/smooth_step.h"

#include <algorithm>
#include <numbers>

namespace trivar {
namespace {

constexpr double cut_taper = 0.15;    // share of the length at each end over which a profile rises
constexpr double widths_of_reach = 3; // where an incision does not say it
// Both lips together are twice as long as the cut, and go round a circle of this width.
constexpr double widest_of_length = 2 / std::numbers::pi;
constexpr double blade_taper = 0.1; // share of the length over which a wound closes at the blade

double on_polyline(const std::vector<glm::dvec2>& points, double x)
{
    if (points.empty()) return 1;
    if (x <= points.front().x) return points.front().y;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 a = points[i - 1], b = points[i];
        if (x <= b.x) return b.x > a.x ? a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y) : b.y;
    }
    return points.back().y;
}

IncisionProfile turned_round(IncisionProfile profile)
{
    std::ranges::reverse(profile.points);
    for (glm::dvec2& p : profile.points) p.x = 1 - p.x;
    return profile;
}

} // namespace

double value_at(const IncisionProfile& profile, double x)
{
    if (!(x > 0 && x < 1)) return 0;
    if (profile.shape == IncisionProfile::Shape::lens) {
        const double c = 2 * x - 1;
        return (1 - c * c) * (1 - c * c);
    }
    const double ends = smooth_step(x / cut_taper) * smooth_step((1 - x) / cut_taper);
    if (profile.shape == IncisionProfile::Shape::even) return ends;
    return ends * std::clamp(on_polyline(profile.points, x), 0.0, 1.0);
}

double value_round(const IncisionProfile& profile, double x)
{
    if (profile.shape != IncisionProfile::Shape::custom) return 1;
    return std::clamp(on_polyline(profile.points, x), 0.0, 1.0);
}

double width_of(const Incision& cut, double length)
{
    return std::min(cut.width, widest_of_length * length);
}

double reach_of(const Incision& cut, double length)
{
    if (cut.reach > 0) return cut.reach;
    return std::min(widths_of_reach * (width_of(cut, length) + 2 * cut.bevel),
                    length + 2 * cut.bevel);
}

double length_of(std::span<const SurfacePoint> stroke)
{
    double out = 0;
    for (std::size_t i = 1; i < stroke.size(); ++i)
        out += glm::distance(stroke[i - 1].p, stroke[i].p);
    return out;
}

Incision reversed(Incision cut)
{
    std::ranges::reverse(cut.stroke);
    cut.depth_profile = turned_round(std::move(cut.depth_profile));
    cut.opening_profile = turned_round(std::move(cut.opening_profile));
    cut.lean_deg = -cut.lean_deg; // what was left of it is right of it
    return cut;
}

Incision mirrored(Incision cut)
{
    for (SurfacePoint& each : cut.stroke) {
        each.p.x = -each.p.x;
        each.normal.x = -each.normal.x;
    }
    cut.lean_deg = -cut.lean_deg;
    return cut;
}

IncisionOpening reversed(const IncisionOpening& opening)
{
    return {opening.share, 1 - opening.to, 1 - opening.from};
}

double share_at(const IncisionOpening& opening, double x)
{
    const double behind = opening.from > 0 ? smooth_step((x - opening.from) / blade_taper) : 1;
    const double before = opening.to < 1 ? smooth_step((opening.to - x) / blade_taper) : 1;
    return opening.share * behind * before;
}

} // namespace trivar

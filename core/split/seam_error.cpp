// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/opening_bounds.h"
#include "core/split/side_bound.h"
#include "core/split/split_error.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// The second derivative by which a kink counts: a function whose slope jumps by 1 over a length of
// 1 is off by a quarter of that from a linear one.
constexpr double bend_of_kink = 1 / (4 * share_of_edge);

// Bounds of how fast a point moves, and how fast that changes, along an edge.
struct EdgeMotion {
    double first = 0, second = 0;
};

// Bounds the motion of w' along an edge where the fade lies between two values and changes by
// `fading`.
EdgeMotion drawn_w(const glm::dvec2& e, const SeamBound& seam, const ShareBound& share,
                   double least_fade, double fade, const EdgeMotion& fading)
{
    const double v = std::abs(e.x), w = std::abs(e.y);
    const double first = share.first * v, second = share.second * v * v;
    const double pull = fade * share.value, least_pull = least_fade * share.least;
    const double slope = std::max(1 + pull * (seam.slope - 1), 1 + least_pull * (seam.slope - 1));
    const double pull_1 = fading.first * share.value + fade * first;
    const double pull_2 = fading.second * share.value + 2 * fading.first * first + fade * second;
    return {w * slope + pull_1 * seam.most,
            pull_2 * seam.most + 2 * pull_1 * seam.slope_less_1 * w +
                pull * (seam.bend * w * w + bend_of_kink * seam.kink * w)};
}

// Bounds the motion of a function of (v, w') along an edge.
EdgeMotion motion_of(const JetBound& f, double v, const EdgeMotion& w)
{
    return {f.v * v + f.w * w.first,
            f.vv * v * v + 2 * f.vw * v * w.first + f.ww * w.first * w.first + f.w * w.second};
}

} // namespace

SplitError::SideErrors SplitError::drawn_in_by_sides(std::size_t opening,
                                                     const std::array<glm::dvec3, 3>& uvw,
                                                     const std::array<double, 3>& heights) const
{
    SideErrors out{};
    const Opening& each = field_.openings[opening];
    const OpeningBounds& bounds = *each.bounds;
    const glm::dvec3 lo = glm::min(glm::min(uvw[0], uvw[1]), uvw[2]);
    const glm::dvec3 hi = glm::max(glm::max(uvw[0], uvw[1]), uvw[2]);
    std::array<glm::dvec2, 3> e; // edges, by (v, w)
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 way = uvw[(i + 1) % 3] - uvw[i];
        e[i] = {way.y, way.z};
    }
    const SeamBound seam = bound(seams_[opening], lo.z, hi.z);
    const ShareBound share = share_bound(seams_[opening], lo.y, hi.y);
    // The range of w from its present place to the place to which it may be drawn.
    const glm::dvec2 from(lo.y, seam.lo), to(hi.y, seam.hi);
    const JetBound phi = bounds.surface.over(from, to);
    double phi_ee = 0;
    for (const glm::dvec2& edge : e) phi_ee = std::max(phi_ee, phi.second(edge));
    const double bend = share_of_bend * phi_ee;
    const double least = std::ranges::min(heights), most = std::ranges::max(heights);
    const bool across = least - bend <= 0 && most + bend >= 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::optional<SideBound> in_reach = side_bound(each, side, least, most, bend);
        if (!in_reach) continue;
        const auto& [r, nearest, farthest, kernel, slope, curve] = *in_reach;
        const JetBound wall = bounds.walls[side].over(from, to);
        // The fade is the square of these
        const double far = std::max(0.0, 1 - nearest / drawn_reach);
        const double near = std::max(0.0, 1 - farthest / drawn_reach);
        const double q = drawn_reach * r;
        for (std::size_t i = 0; i < 3; ++i) {
            // The change of the distance from the surface along the edge
            const double a = std::abs(heights[(i + 1) % 3] - heights[i]) + phi_ee;
            const EdgeMotion fading =
                far == 0 ? EdgeMotion{}
                         : EdgeMotion{2 * far * a / q, 2 * a * a / (q * q) + 2 * far * phi_ee / q};
            const EdgeMotion w = drawn_w(e[i], seam, share, near * near, far * far, fading);
            const EdgeMotion wall_w = motion_of(wall, std::abs(e[i].x), w);
            const double u = phi_ee + motion_of(phi, std::abs(e[i].x), w).second +
                             kernel.value * wall_w.second + 2 * slope * wall_w.first * a +
                             wall.value * (curve * a * a + slope * phi_ee);
            out[side][i] = share_of_edge * (std::hypot(u, w.second) + (across ? phi_ee : 0));
        }
    }
    return out;
}

EdgeErrors SplitError::drawn_in_cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const
{
    const OpeningBounds& bounds = *field_.openings[opening].bounds;
    const glm::dvec2 lo = glm::min(glm::min(vw[0], vw[1]), vw[2]);
    const glm::dvec2 hi = glm::max(glm::max(vw[0], vw[1]), vw[2]);
    const SeamBound seam = bound(seams_[opening], lo.y, hi.y);
    const ShareBound share = share_bound(seams_[opening], lo.x, hi.x);
    const glm::dvec2 from(lo.x, seam.lo), to(hi.x, seam.hi);
    const JetBound phi = bounds.surface.over(from, to);
    EdgeErrors out{};
    for (const SurfaceBounds& wall : bounds.walls) {
        const JetBound bound_of_wall = wall.over(from, to);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 e = vw[(i + 1) % 3] - vw[i];
            const EdgeMotion w = drawn_w(e, seam, share, 1, 1, {});
            const double v = std::abs(e.x);
            const double u = motion_of(phi, v, w).second + motion_of(bound_of_wall, v, w).second;
            out[i] = std::max(out[i], share_of_edge * std::hypot(u, w.second));
        }
    }
    return out;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split_error.h"

#include "core/split/opening_bounds.h"
#include "core/split/side_bound.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Bounds the bends of both walls: few parts are looked at one by one, many by their greatest.
BendBounds::Bend bends_of_walls(const OpeningBounds& bounds, const glm::dvec2& lo,
                                const glm::dvec2& hi)
{
    constexpr int few = 12;
    const SurfaceBounds::Cells parts = bounds.walls[0].cells(lo, hi);
    if ((parts.to_v - parts.from_v + 1) * (parts.to_w - parts.from_w + 1) > few)
        return bounds.wall_bends.over(lo, hi);
    JetBound both = bounds.walls[0].over(parts);
    both.add(bounds.walls[1].over(parts));
    return {both.vv, both.vw, both.ww};
}

bool apart(const glm::dvec2& lo, const glm::dvec2& hi, const glm::dvec2& other_lo,
           const glm::dvec2& other_hi)
{
    return hi.x <= other_lo.x || lo.x >= other_hi.x || hi.y <= other_lo.y || lo.y >= other_hi.y;
}

} // namespace

double whole_error(const EdgeErrors& edges)
{
    const auto& [a, b, c] = edges;
    const double most = std::max({a, b, c});
    if (2 * most >= a + b + c) return most; // on the longest edge
    return 4 * a * b * c / (2 * (a * b + b * c + c * a) - a * a - b * b - c * c);
}

EdgeErrors SplitError::edges(const std::array<glm::dvec3, 3>& uvw,
                             const std::array<const double*, 3>& heights) const
{
    EdgeErrors out{};
    for (std::size_t k = 0; k < field_.openings.size(); ++k)
        for (const EdgeErrors& side :
             by_sides(k, uvw, {heights[0][k], heights[1][k], heights[2][k]}))
            for (std::size_t i = 0; i < 3; ++i) out[i] += side[i];
    return out;
}

// Bounds the error of the triangle at opening k, for each side of it.
SplitError::SideErrors SplitError::by_sides(std::size_t k, const std::array<glm::dvec3, 3>& uvw,
                                            const std::array<double, 3>& heights) const
{
    SideErrors out{};
    const Opening& each = field_.openings[k];
    const OpeningBounds& bounds = *each.bounds;
    const glm::dvec3 lo = glm::min(glm::min(uvw[0], uvw[1]), uvw[2]);
    const glm::dvec3 hi = glm::max(glm::max(uvw[0], uvw[1]), uvw[2]);
    const glm::dvec2 lo2(lo.y, lo.z), hi2(hi.y, hi.z);
    if (apart(lo2, hi2, each.walls[0].lo(), each.walls[0].hi())) return out;
    if (draws(k)) return drawn_in_by_sides(k, uvw, heights);
    std::array<glm::dvec2, 3> e; // edges, by (v, w)
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& from = uvw[i];
        const glm::dvec3& to = uvw[i == 2 ? 0 : i + 1];
        e[i] = {to.y - from.y, to.z - from.z};
    }
    const double least = std::min({heights[0], heights[1], heights[2]});
    const double most = std::max({heights[0], heights[1], heights[2]});
    // The surface over the triangle: its values at the corners and how it bends between them
    const JetBound phi = bounds.surface.over(lo2, hi2);
    std::array<double, 3> phi_ee; // second derivatives along the edges
    for (std::size_t i = 0; i < 3; ++i) phi_ee[i] = phi.second(e[i]);
    const double bend = share_of_bend * std::max({phi_ee[0], phi_ee[1], phi_ee[2]});
    const bool across = least - bend <= 0 && most + bend >= 0;
    const SurfaceBounds::Cells cells = bounds.walls[0].cells(lo2, hi2); // of both walls
    for (std::size_t side = 0; side < 2; ++side) {
        const std::optional<SideBound> in_reach = side_bound(each, side, least, most, bend);
        if (!in_reach) continue;
        const auto& [reach, nearest, farthest, kernel, slope, curve] = *in_reach;
        const JetBound w = bounds.walls[side].over(cells);
        for (std::size_t i = 0; i < 3; ++i) {
            // The change of the distance from the surface along the edge
            const double a = std::abs(heights[i == 2 ? 0 : i + 1] - heights[i]) + phi_ee[i];
            const double second = kernel.value * w.second(e[i]) + 2 * slope * w.first(e[i]) * a +
                                  w.value * (curve * a * a + slope * phi_ee[i]);
            // Where the cut goes through, the chord of the surface counts as well
            out[side][i] = share_of_edge * (second + (across ? phi_ee[i] : 0));
        }
    }
    return out;
}

double SplitError::within(const Box& uvw) const
{
    const glm::dvec2 lo(uvw.lo.y, uvw.lo.z), hi(uvw.hi.y, uvw.hi.z), e = hi - lo;
    double out = 0;
    for (const Opening& each : field_.openings) {
        if (apart(lo, hi, each.walls[0].lo(), each.walls[0].hi())) continue;
        const OpeningBounds& bounds = *each.bounds;
        const JetBound phi = bounds.surface.over(lo, hi);
        const SurfaceBounds::Cells cells = bounds.walls[0].cells(lo, hi);
        JetBound w = bounds.walls[0].over(cells);
        w.add(bounds.walls[1].over(cells));
        const double r = std::min(each.reach[0], each.reach[1]);
        const double slope = steepest(each.kernel) / r, curve = most_bent(each.kernel) / (r * r);
        const double phi_ee = phi.second(e), a = uvw.hi.x - uvw.lo.x + phi.first(e) + phi_ee;
        out += share_of_bend * (w.second(e) + 2 * slope * w.first(e) * a +
                                w.value * (curve * a * a + slope * phi_ee) + phi_ee);
    }
    return out;
}

EdgeErrors SplitError::surface(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const
{
    const glm::dvec2 lo = glm::min(glm::min(vw[0], vw[1]), vw[2]);
    const glm::dvec2 hi = glm::max(glm::max(vw[0], vw[1]), vw[2]);
    const BendBounds::Bend phi = field_.openings[opening].bounds->surface_bends.over(lo, hi);
    EdgeErrors out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = share_of_edge * phi.second(vw[i == 2 ? 0 : i + 1] - vw[i]);
    return out;
}

double SplitError::surfaces_within(const Box& uvw) const
{
    const glm::dvec2 lo(uvw.lo.y, uvw.lo.z), hi(uvw.hi.y, uvw.hi.z);
    double out = 0;
    for (const Opening& each : field_.openings)
        out =
            std::max(out, share_of_bend * each.bounds->surface_bends.over(lo, hi).second(hi - lo));
    return out;
}

EdgeErrors SplitError::cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const
{
    EdgeErrors out{};
    const Opening& own = field_.openings[opening];
    const glm::dvec2 lo = glm::min(glm::min(vw[0], vw[1]), vw[2]);
    const glm::dvec2 hi = glm::max(glm::max(vw[0], vw[1]), vw[2]);
    // Beyond the rectangle both caps are one
    const bool beyond = apart(lo, hi, own.walls[0].lo(), own.walls[0].hi());
    if (!beyond && draws(opening)) {
        out = drawn_in_cap(opening, vw);
    } else if (!beyond) {
        const BendBounds::Bend phi = own.bounds->surface_bends.over(lo, hi);
        const BendBounds::Bend wall = bends_of_walls(*own.bounds, lo, hi);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 e = vw[i == 2 ? 0 : i + 1] - vw[i];
            out[i] = share_of_edge * (phi.second(e) + wall.second(e));
        }
    }
    if (field_.openings.size() == 1) return out;
    std::array<glm::dvec3, 3> uvw;
    for (std::size_t i = 0; i < 3; ++i) uvw[i] = {own.surface_cells.value(vw[i]), vw[i]};
    for (std::size_t k = 0; k < field_.openings.size(); ++k) {
        if (k == opening) continue;
        std::array<double, 3> heights{};
        for (std::size_t i = 0; i < 3; ++i) heights[i] = field_.openings[k].height(uvw[i]);
        const SideErrors sides = by_sides(k, uvw, heights);
        // A part that an earlier opening has cut lies on one side of it.
        for (std::size_t i = 0; i < 3; ++i)
            out[i] += k < opening ? std::max(sides[0][i], sides[1][i]) : sides[0][i] + sides[1][i];
    }
    return out;
}

} // namespace trivar

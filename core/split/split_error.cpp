// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/split_error.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// 2 times the largest sum of products of two barycentric coordinates, by the 2 of Taylor's term
constexpr double share_of_bend = 1.0 / 6;

bool apart(const glm::dvec2& lo, const glm::dvec2& hi, const glm::dvec2& other_lo,
           const glm::dvec2& other_hi)
{
    return hi.x <= other_lo.x || lo.x >= other_hi.x || hi.y <= other_lo.y || lo.y >= other_hi.y;
}

} // namespace

SplitError::SplitError(const SplitField& field)
{
    for (const Opening& o : field.openings)
        all_.push_back(
            {SurfaceBounds(o.surface, false),
             {SurfaceBounds(o.walls[0].height, true), SurfaceBounds(o.walls[1].height, true)},
             o.walls[0].lo(),
             o.walls[0].hi(),
             o.reach,
             steepest(o.kernel),
             most_bent(o.kernel)});
}

std::array<double, 3> SplitError::edges(const std::array<glm::dvec3, 3>& uvw,
                                        const std::array<const double*, 3>& all_heights) const
{
    std::array<double, 3> out{};
    const glm::dvec3 lo = glm::min(glm::min(uvw[0], uvw[1]), uvw[2]);
    const glm::dvec3 hi = glm::max(glm::max(uvw[0], uvw[1]), uvw[2]);
    const glm::dvec2 lo2(lo.y, lo.z), hi2(hi.y, hi.z);
    for (std::size_t k = 0; k < all_.size(); ++k) {
        const Each& each = all_[k];
        // Somewhat beyond the walls too, so that the rims of caps that reach under them are fine
        const glm::dvec2 beyond = 0.1 * (each.hi - each.lo);
        if (apart(lo2, hi2, each.lo - beyond, each.hi + beyond)) continue;
        // The surface over the triangle: its values at the corners and how it bends between them
        const JetBound phi = each.surface.over(lo2, hi2);
        const std::array<double, 3> heights{all_heights[0][k], all_heights[1][k],
                                            all_heights[2][k]};
        double bend = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bend = std::max(bend, phi.second(glm::dvec2(uvw[(i + 1) % 3].y - uvw[i].y,
                                                        uvw[(i + 1) % 3].z - uvw[i].z)));
        bend *= share_of_bend;
        const auto [least, most] = std::ranges::minmax(heights);
        const bool across = least - bend <= 0 && most + bend >= 0;
        for (std::size_t side = 0; side < 2; ++side) {
            if (side == 0 ? least - bend >= 0 : most + bend <= 0) continue;
            const double r = each.reach[side];
            if (side == 0 ? most + bend <= -r : least - bend >= r) continue; // beyond the reach
            const JetBound w = each.walls[side].over(lo2, hi2);
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 e3 = uvw[(i + 1) % 3] - uvw[i];
                const glm::dvec2 e(e3.y, e3.z);
                const double phi_ee = phi.second(e);
                // The change of the distance from the surface along the edge
                const double a = std::abs(heights[(i + 1) % 3] - heights[i]) + phi_ee;
                const double second = w.second(e) + 2 * w.first(e) * each.steepest * a / r +
                                      w.value * each.most_bent * a * a / (r * r) +
                                      w.value * each.steepest * phi_ee / r;
                // Where the cut goes through, the chord of the surface counts as well
                out[i] += share_of_bend * (second + (across ? phi_ee : 0));
            }
        }
    }
    return out;
}

double SplitError::cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const
{
    const Each& each = all_[opening];
    const glm::dvec2 lo = glm::min(glm::min(vw[0], vw[1]), vw[2]);
    const glm::dvec2 hi = glm::max(glm::max(vw[0], vw[1]), vw[2]);
    if (apart(lo, hi, each.lo, each.hi)) return 0; // both caps are one there
    const JetBound phi = each.surface.over(lo, hi);
    double most = 0;
    for (const SurfaceBounds& wall : each.walls) {
        const JetBound w = wall.over(lo, hi);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 e = vw[(i + 1) % 3] - vw[i];
            most = std::max(most, share_of_bend * (phi.second(e) + w.second(e)));
        }
    }
    return most;
}

} // namespace trivar

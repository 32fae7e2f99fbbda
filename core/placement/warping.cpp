// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/warping.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Rotates x and y by an angle in radians, from x toward y.
glm::dvec2 turned(const glm::dvec2& p, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

Lattice warped(const Lattice& volume, const Warp& warp)
{
    const glm::dmat4 to_uvw = glm::inverse(volume.rest);
    const glm::dmat3 axes(volume.rest);
    const glm::dvec3 size(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
    std::vector<PointMove> moves;
    const std::array<Knots, 3>& knots = volume.displacement.axes;
    for (int i = 0; i < knots[0].count(); ++i)
        for (int j = 0; j < knots[1].count(); ++j)
            for (int k = 0; k < knots[2].count(); ++k) {
                const glm::dvec3 from = control_point(volume, i, j, k);
                const glm::dvec3 uvw(to_uvw * glm::dvec4(from, 1));
                const glm::dvec3 p = warped((uvw - 0.5) * size, size, warp) / size + 0.5;
                moves.push_back({{i, j, k}, glm::dvec3(volume.rest * glm::dvec4(p, 1)) - from});
            }
    return moved(volume, moves);
}

double most_moved(const Lattice& a, const Lattice& b)
{
    double most = 0;
    for (std::size_t p = 0; p < a.displacement.points.size(); ++p)
        most = std::max(most, glm::length(a.displacement.points[p] - b.displacement.points[p]));
    return most;
}

bool was_a_box(const LaidVolume& volume)
{
    return std::ranges::all_of(volume.as_laid->displacement.points,
                               [](const glm::dvec3& d) { return d == glm::dvec3(0); });
}

} // namespace

// Warps a point, where a is the axis, b the next one, c the third and t = 0..1 along a; toward
// turns b and c first.
glm::dvec3 warped(const glm::dvec3& p, const glm::dvec3& size, const Warp& warp)
{
    const int a = static_cast<int>(warp.axis), b = (a + 1) % 3, c = (a + 2) % 3;
    const double length = size[a], t = p[a] / length + 0.5;
    const double still = (warp.fixed - 0.5) * length; // on the axis
    double along = p[a];
    glm::dvec2 across(p[b], p[c]);
    across *= (1 + warp.bulge * 4 * t * (1 - t)) * (1 + warp.taper * t);
    const double toward = glm::radians(warp.toward_deg);
    across = turned(across, -toward);
    across.x += warp.shear * length * t;
    if (const double bend = glm::radians(warp.bend_deg); bend != 0) {
        const double radius = length / bend, angle = (along - still) / radius;
        along = still + (radius - across.x) * std::sin(angle);
        across.x = radius - (radius - across.x) * std::cos(angle);
    }
    across = turned(across, toward + glm::radians(warp.twist_deg) * (t - warp.fixed));
    glm::dvec3 out(0);
    out[a] = along;
    out[b] = across.x;
    out[c] = across.y;
    return out;
}

Warp part_of(Warp warp, double share)
{
    for (double* amount : {&warp.twist_deg, &warp.bend_deg, &warp.taper, &warp.shear, &warp.bulge})
        *amount *= share;
    return warp;
}

WarpedVolume warped(const LaidVolume& volume, const Warp& warp)
{
    if (!was_a_box(volume))
        throw Rejected("only a lattice that is a box can be twisted, bent, tapered, sheared or "
                       "bulged; use the profiles of a volume on a stroke");
    const auto at = [&](double share) { return warped(*volume.volume, part_of(warp, share)); };
    if (!warp.guard || !volume.verdicts->good()) {
        Lattice after = at(1);
        const double far = most_moved(after, *volume.volume);
        return {with_volume(volume, std::move(after)), 1, far};
    }
    constexpr int steps = 64;
    int most = 0; // found by bisection, the whole motion first
    for (int step = steps; step > 0; step /= 2)
        if (most + step <= steps &&
            judge(at(static_cast<double>(most + step) / steps), volume.guard()).good())
            most += step;
    const double share = static_cast<double>(most) / steps;
    Lattice after = at(share);
    const double far = most_moved(after, *volume.volume);
    return {with_volume(volume, std::move(after)), share, far};
}

} // namespace trivar

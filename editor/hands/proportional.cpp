// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/proportional.h"

#include "core/base/smooth_step.h"
#include "core/placement/shifting.h"
#include "editor/hands/point_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace trivar {

double falloff(Falloff kind, double x)
{
    if (!(x < 1)) return 0;
    const double near = 1 - x;
    switch (kind) {
    case Falloff::smooth: return smooth_step(near);
    case Falloff::sphere: return std::sqrt(near * (2 - near));
    case Falloff::root: return std::sqrt(near);
    case Falloff::linear: return near;
    case Falloff::sharp: return near * near;
    case Falloff::constant: return 1;
    }
    return 0;
}

std::vector<PointDistance> by_distance(const Lattice& volume, const PointShift& shift)
{
    const glm::ivec3 n = point_count(volume);
    const auto at = [&](const glm::ivec3& p) { return control_point(volume, p.x, p.y, p.z); };
    PointShift sided = shift;
    sided.weights.assign(sided.points.size(), 1); // a first one in the middle has a far side
    const auto away = [&](const glm::ivec3& p) { return away_from_first(p, n, sided); };
    std::vector<PointDistance> out;
    std::vector<char> taken(volume.displacement.points.size());
    std::vector<glm::dvec3> held;
    for (const glm::ivec3& each : shift.points) {
        const glm::ivec3 p = mirrored_point(each, n, away(each));
        if (std::exchange(taken[volume.displacement.index(p.x, p.y, p.z)], 1) != 0) continue;
        out.push_back({p, 0});
        for (int mask = 0; mask < 8; ++mask)
            if ((mask & ~mirror_axes(shift)) == 0) held.push_back(at(mirrored_point(p, n, mask)));
    }
    for (const glm::ivec3& p : all_points(n)) {
        if (taken[volume.displacement.index(p.x, p.y, p.z)] != 0 || away(p) != 0) continue;
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& from : held) least = std::min(least, glm::distance(at(p), from));
        out.push_back({p, least});
    }
    return out;
}

PointShift with_neighbours(PointShift shift, const std::vector<PointDistance>& points, Falloff kind,
                           double radius_m)
{
    shift.points.clear();
    shift.weights.clear();
    for (const PointDistance& each : points) {
        const double share = each.metres == 0 ? 1 : falloff(kind, each.metres / radius_m);
        if (!(share > 0)) continue;
        shift.points.push_back(each.point);
        shift.weights.push_back(share);
    }
    return shift;
}

} // namespace trivar

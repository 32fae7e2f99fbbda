// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/shifting.h"

#include "core/base/rejected.h"

#include <array>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

namespace trivar {
namespace {

glm::ivec3 count_of(const Lattice& volume)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    return {axes[0].count(), axes[1].count(), axes[2].count()};
}

// Returns twice the distance from the middle along an axis, in steps between points.
int side(const glm::ivec3& p, const glm::ivec3& n, int axis)
{
    return 2 * p[axis] - (n[axis] - 1);
}

double weight(const PointShift& shift, std::size_t point)
{
    return shift.weights.empty() ? 1 : shift.weights[point];
}

const glm::dvec3& direction(const VolumeDirections& at, int axis)
{
    return axis == 0 ? at.along : axis == 1 ? at.across : at.up;
}

void check_points(const PointShift& shift, const glm::ivec3& n)
{
    if (shift.of != glm::ivec3(0) && shift.of != n)
        throw Rejected(fmt::format("it moves control points of a volume of {} x {} x {}, but the "
                                   "volume has {} x {} x {} now",
                                   shift.of.x, shift.of.y, shift.of.z, n.x, n.y, n.z));
    for (const glm::ivec3& p : shift.points)
        for (int a = 0; a < 3; ++a)
            if (p[a] < 0 || p[a] >= n[a])
                throw Rejected(fmt::format(
                    "the control point {}, {}, {} no longer exists; the volume has {} x {} x {}",
                    p.x, p.y, p.z, n.x, n.y, n.z));
}

// A Shifting applies one shift to one volume.
class Shifting {
public:
    Shifting(const Lattice& volume, const PointShift& shift)
        : volume_(volume),
          shift_(shift),
          n_(count_of(volume)),
          first_(directions(shift.points.front())),
          turns_(shift.rotation_deg != glm::dvec3(0) || shift.factors != glm::dvec3(1))
    {
        if (turns_) middle_ = middle_of(volume, shift);
        const int mirrored = mirror_axes(shift);
        for (int mask = 0; mask < 8; ++mask)
            if ((mask & ~mirrored) == 0)
                sides_[static_cast<std::size_t>(mask)] =
                    directions(mirrored_point(shift.points.front(), n_, mask));
    }

    // Returns the motion of a point with that share of it.
    glm::dvec3 world(const glm::ivec3& p, double share) const
    {
        const int away = away_from_first(p, n_, shift_);
        glm::dvec3 by = share * shift_.by;
        if (turns_) by += turned(mirrored_point(p, n_, away), share);
        for (int a = 0; a < 3; ++a)
            if ((away & (1 << a)) != 0) by[a] = -by[a];
        glm::dvec3 out = sides_[static_cast<std::size_t>(away)].to_world(by);
        for (int a = 0; a < 3; ++a)
            if ((mirror_axes(shift_) & (1 << a)) != 0 && side(p, n_, a) == 0) {
                const VolumeDirections here = directions(p); // the middle keeps its side
                out -= glm::dot(out, direction(here, a)) * direction(here, a);
            }
        return out;
    }

private:
    VolumeDirections directions(const glm::ivec3& p) const
    {
        return volume_directions(volume_, greville(volume_, p));
    }
    // Returns the motion by rotation and scaling about the middle, along the directions of the
    // first point.
    glm::dvec3 turned(const glm::ivec3& p, double share) const
    {
        const glm::dvec3 from = control_point(volume_, p.x, p.y, p.z) - middle_;
        const glm::dvec3 at(glm::dot(from, first_.along), glm::dot(from, first_.across),
                            glm::dot(from, first_.up));
        const glm::dvec3 scaled = (1.0 + share * (shift_.factors - 1.0)) * at;
        const glm::dvec3 angles = glm::radians(share * shift_.rotation_deg);
        glm::dmat4 turned(1); // about along first, about up last
        for (const int axis : {2, 1, 0}) {
            glm::dvec3 about(0);
            about[axis] = 1;
            turned = glm::rotate(turned, angles[axis], about);
        }
        return glm::dmat3(turned) * scaled - at;
    }

    const Lattice& volume_;
    const PointShift& shift_;
    glm::ivec3 n_;
    VolumeDirections first_;
    bool turns_;
    glm::dvec3 middle_{0};
    std::array<VolumeDirections, 8> sides_ = {}; // where the first point is, mirrored so
};

} // namespace

int mirror_axes(const PointShift& shift)
{
    return (shift.mirror_along ? 1 : 0) | (shift.mirror ? 2 : 0) | (shift.mirror_up ? 4 : 0);
}

glm::ivec3 mirrored_point(glm::ivec3 point, const glm::ivec3& count, int axes)
{
    for (int a = 0; a < 3; ++a)
        if ((axes & (1 << a)) != 0) point[a] = count[a] - 1 - point[a];
    return point;
}

int away_from_first(const glm::ivec3& point, const glm::ivec3& count, const PointShift& shift)
{
    int out = 0;
    for (int a = 0; a < 3; ++a) {
        if ((mirror_axes(shift) & (1 << a)) == 0) continue;
        int first = side(shift.points.front(), count, a);
        if (first == 0 && !shift.weights.empty()) first = 1;
        if (side(point, count, a) * first < 0) out |= 1 << a;
    }
    return out;
}

glm::dvec3 middle_of(const Lattice& volume, const PointShift& shift)
{
    const glm::ivec3 n = count_of(volume);
    glm::dvec3 held(0), all(0);
    int count = 0;
    for (std::size_t i = 0; i < shift.points.size(); ++i) {
        const glm::ivec3 p =
            mirrored_point(shift.points[i], n, away_from_first(shift.points[i], n, shift));
        const glm::dvec3 at = control_point(volume, p.x, p.y, p.z);
        all += at;
        if (weight(shift, i) < 1) continue;
        held += at;
        ++count;
    }
    return count > 0 ? held / static_cast<double>(count)
                     : all / static_cast<double>(shift.points.size());
}

std::vector<PointMove> moves_of(const Lattice& volume, const PointShift& shift)
{
    const glm::ivec3 n = count_of(volume);
    check_points(shift, n);
    std::vector<PointMove> out;
    if (shift.points.empty()) return out;
    const Shifting shifting(volume, shift);
    std::map<std::array<int, 3>, glm::dvec3> by; // each point once
    for (std::size_t i = 0; i < shift.points.size(); ++i)
        for (int mask = 0; mask < 8; ++mask) {
            if ((mask & ~mirror_axes(shift)) != 0) continue;
            const glm::ivec3 p = mirrored_point(shift.points[i], n, mask);
            by.emplace(std::array{p.x, p.y, p.z}, shifting.world(p, weight(shift, i)));
        }
    for (const auto& [p, world] : by) out.push_back({{p[0], p[1], p[2]}, world});
    return out;
}

} // namespace trivar

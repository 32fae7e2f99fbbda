// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/shaping.h"

#include "core/base/unit.h"

#include <cmath>

namespace trivar {
namespace {

// Returns some unit vector at a right angle to v.
glm::dvec3 any_across(const glm::dvec3& v)
{
    const glm::dvec3 axis = std::abs(v.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(v, axis));
}

} // namespace

VolumePart bent_by(const Lattice& volume, std::span<const glm::ivec3> points)
{
    VolumePart out{glm::dvec3(1), glm::dvec3(0)};
    for (const glm::ivec3& p : points) {
        VolumePart one;
        bool mirrored = false; // whether it crosses the seam of a twisted axis
        for (int a = 0; a < 3; ++a) {
            const Knots& axis = volume.displacement.axes[static_cast<std::size_t>(a)];
            const auto first = static_cast<std::size_t>(p[a]);
            const double begin = axis.values()[first],
                         end = axis.values()[first + static_cast<std::size_t>(axis.order())];
            if (begin < axis.begin() || end > axis.end()) {
                mirrored = axis.closure() == Closure::twisted;
                continue;
            }
            one.lo[a] = begin;
            one.hi[a] = end;
        }
        out.lo = glm::min(out.lo, one.lo);
        out.hi = glm::max(out.hi, one.hi);
        if (!mirrored) continue;
        out.lo = glm::min(out.lo, 1.0 - one.hi);
        out.hi = glm::max(out.hi, 1.0 - one.lo);
    }
    return out;
}

double decay(Decay decay, double x)
{
    if (!(x < 1)) return 0;
    switch (decay) {
    case Decay::gaussian: {
        static const double at_rim = std::exp(-4.5);
        return (std::exp(-4.5 * x * x) - at_rim) / (1 - at_rim);
    }
    case Decay::hat: return 1 - x;
    case Decay::box: return 1;
    case Decay::smooth: return (1 - x * x) * (1 - x * x);
    }
    return 0;
}

VolumeDirections volume_directions(const Lattice& volume, const glm::dvec3& uvw)
{
    const Jet<glm::dvec3> f = evaluate(volume, uvw, 1);
    VolumeDirections frame;
    frame.up = unit_or(f.first[2], {0, 0, 1});
    const glm::dvec3 along = f.first[0] - glm::dot(f.first[0], frame.up) * frame.up;
    frame.along = unit_or(along, any_across(frame.up));
    frame.across = glm::cross(frame.up, frame.along);
    return frame;
}

} // namespace trivar

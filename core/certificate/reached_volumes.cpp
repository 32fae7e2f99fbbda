// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/reached_volumes.h"

#include "core/ffd/prolong.h"
#include "core/placement/journey.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double seam_rounding = 1e-9; // of u

// Bounds the distance from F(u) to F(u + period) of a volume that is run through twice: its second
// round begins with the last control points of the first, whose weights are at most 1.
double seam_of(const Lattice& lattice)
{
    const std::vector<glm::dvec3>& points = lattice.displacement.points;
    const std::ptrdiff_t slice = std::ssize(points) / lattice.displacement.axes[0].count();
    double most = 0;
    for (std::ptrdiff_t s = 0; s < slice; ++s)
        most = std::max(most, glm::distance(points.begin()[s], (points.end() - slice)[s]));
    const Knots& axis = lattice.displacement.axes[0];
    return most + glm::length(glm::dvec3(lattice.rest[0])) * (axis.end() - axis.begin());
}

} // namespace

std::optional<ReachedVolumes::ReachedVolume>
ReachedVolumes::over(const EvaluatedObject& object, double from, double to, double laps,
                     const std::array<Ref<Lattice>, 2>& at)
{
    const Ref<Lattice> at_rest(object.placement, &object.placement->volume);
    const Knots& axis = at_rest->displacement.axes[0];
    const double begin = axis.begin() - seam_rounding, end = axis.end() + seam_rounding,
                 period = axis.end() - axis.begin();
    if (!object.journey || axis.closure() != Closure::open) return ReachedVolume{at_rest};
    if (laps == 0 && from >= begin && to <= end) return ReachedVolume{at_rest};
    // Only a model that goes round leaves a volume and comes back.
    const bool rounds = object.journey->rounds();
    if (laps == 0 && at[0] == at[1] && !rounds) return ReachedVolume{at[0]};
    if (laps != 0 && (!rounds || std::abs(laps) > 1)) return {};
    Longer& longer = longer_[object.placement];
    if (!rounds) {
        if (!longer.volume || from < longer.from || to > longer.to) {
            const double room = period / 8; // so that it is not prolonged again each time
            longer.from = std::min({longer.from, from - room, axis.begin()});
            longer.to = std::max({longer.to, to + room, axis.end()});
            longer.volume = make_ref(prolonged(*at_rest, 0, longer.from, longer.to));
        }
        return ReachedVolume{.volume = longer.volume, .clamped = true};
    }
    if (!longer.volume) longer.volume = make_ref(twice_round(*at_rest));
    ReachedVolume out{.volume = longer.volume, .clamped = true};
    if (from < begin) out.shift_u = period;
    if (from + out.shift_u < begin || to + out.shift_u > end + period) return {};
    if (laps != 0 || out.shift_u != 0) out.seam = seam_of(*at_rest);
    return out;
}

} // namespace trivar

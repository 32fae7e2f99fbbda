// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/reaching.h"

#include "core/ffd/prolong.h"

#include <algorithm>

namespace trivar {

Ref<Lattice> reaching(const Ref<Lattice>& volume, const Journey& journey,
                      const PlacementParameters& p, const std::vector<Journey::Place>& places)
{
    if (volume->displacement.axes[0].closure() != Closure::open) return volume;
    constexpr double slack = 1e-3; // the faces of a model lie on its box up to rounding
    double from = 0, to = 1;
    for (const Journey::Place& place : places) {
        if (place.hidden) continue;
        from = std::min(from, p.start + place.shift_u);
        to = std::max(to, p.start + place.shift_u + p.fill);
    }
    if (from >= -1e-9 && to <= 1 + 1e-9) return volume;
    if (journey.rounds()) return make_ref(twice_round(*volume));
    return make_ref(prolonged(*volume, 0, from - slack, to + slack));
}

} // namespace trivar

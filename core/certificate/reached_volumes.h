// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"

#include <map>
#include <optional>

namespace trivar {

// ReachedVolumes gives the volume of a stroke as far as an object that travels on it comes between
// two moments. An evaluation lengthens a volume, or runs through it twice, only as far as its one
// moment needs; a volume given here is the same function as all of those.
class ReachedVolumes {
public:
    struct ReachedVolume {
        Ref<Lattice> volume;
        double shift_u = 0; // shift along u of what lies in the volume
        // metres; a point in this volume is at most this far from its place in the scene
        double seam = 0;
        // points outside of their model's box along the stroke are excepted from `seam`
        bool clamped = false;
    };
    // `from` and `to` are the ends in u of what lies there, at all times between two moments.
    // `laps` is the number of laps that began meanwhile and that u does not show. The two volumes
    // are those at both moments. Empty: not known.
    std::optional<ReachedVolume> over(const EvaluatedObject& object, double from, double to,
                                      double laps, const std::array<Ref<Lattice>, 2>& at_moments);

private:
    struct Longer {
        double from = 0, to = 0;
        Ref<Lattice> volume;
    };
    std::map<Ref<Placement>, Longer> longer_;
};

} // namespace trivar

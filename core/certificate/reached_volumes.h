// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"

#include <map>
#include <optional>

namespace trivar {

// The volumes of strokes as far as what travels on them comes between two moments. An evaluation
// prolongs a volume, or runs through it twice, as far as it needs at its moment alone; here one
// volume is the same function as all of those.
class ReachedVolumes {
public:
    struct ReachedVolume {
        Ref<Lattice> volume;
        double shift_u = 0;   // of what lies there in it
        double seam = 0;      // metres: no further is a point in it from where the scene has it,
        bool clamped = false; // but for what it is out of its model's box along the stroke
    };
    // Of what lies from u = `from` to `to` at all times between two moments, with `laps` begun
    // meanwhile that its u does not show, and in these volumes at the two. Nothing: it is not
    // known.
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

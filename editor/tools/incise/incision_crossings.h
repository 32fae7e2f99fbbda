// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/incise/seen_incision.h"

namespace trivar {

// A IncisionCrossing is a place where two incisions cross, seen on the shut skin.
struct IncisionCrossing {
    int first = 1, second = 2; // their numbers, the lower one first
    double share_of_first = 0, share_of_second = 0;
    SurfaceHit at;
    int other_than(int number) const { return number == first ? second : first; }
    double share_of(int number) const { return number == first ? share_of_first : share_of_second; }
};

// All crossings of incisions, by number; those that are not seen have no line. Incisions that
// cross themselves are no crossing of two.
std::vector<IncisionCrossing> crossings_of(const std::vector<std::optional<SeenIncision>>& cuts);

} // namespace trivar

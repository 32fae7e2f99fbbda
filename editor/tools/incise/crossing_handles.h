// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/incise/incision_crossings.h"
#include "editor/tools/incise/incision_handles.h"

namespace trivar {

// A SeenIncising is all that is seen of an object's incisions, by number; nothing of hidden ones.
struct SeenIncising {
    const Incising& incising;
    const std::vector<std::optional<SeenIncision>>& cuts;
    const std::vector<IncisionCrossing>& crossings;
};

// The handles where incision `number` crosses others, by the kinds of their keys, with the numbers
// of both: "crossing", which slides along the chosen one and takes the other one with it, and which
// a click swaps; and "flap", of those between both at the crossing that is nearest to a pixel,
// where it is near. `scale`: of the interface.
std::vector<Handle> crossing_handles(const SeenIncising& seen, int number, const Camera& camera,
                                     glm::dvec2 near_px, double scale, const TakeIncision& take);

} // namespace trivar

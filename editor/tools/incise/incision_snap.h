// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/tools/incise/seen_incision.h"

#include <optional>

namespace trivar {

// An IncisionSnap is a place of another incision to which a stroke and its ends are pulled: an end
// of that, a place along it, or one where two others cross, through which a stroke may go on.
struct IncisionSnap {
    SurfacePoint at_rest;
    glm::dvec3 p_world{0};
    bool along = false, crossing = false;
};
struct IncisionSnaps {
    std::vector<IncisionSnap> ends;
    std::vector<std::vector<SurfaceHit>> lines; // of incisions, from start to end
    bool empty() const { return ends.empty() && lines.empty(); }
};
// Adds an incision, and those of its ends that are on the skin; of one in parts the longest.
void add_snaps(IncisionSnaps& snaps, const SeenIncision& cut,
               const std::vector<SurfacePoint>& stroke);
// Takes away what begins or ends at a place, or goes through it.
void forget_place(IncisionSnaps& snaps, const IncisionSnap& place);

// The nearest end near a pixel, else the nearest place along an incision; nothing: all are far.
std::optional<IncisionSnap> snap_near(const IncisionSnaps& snaps, const Camera& camera,
                                      glm::dvec2 p_px, double scale);

} // namespace trivar

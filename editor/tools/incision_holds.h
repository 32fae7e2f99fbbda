// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/incise.h"
#include "editor/tools/seen_cut.h"

#include <string>

namespace trivar {

// What a handle of an incision changes: where an end lies, how far it stands open, how deep it is,
// up to where it is open, where all of it lies.
enum class IncisionHold { none, start, end, open_left, open_right, depth, zip, place };

struct IncisionHoldPoint {
    IncisionHold hold = IncisionHold::none;
    glm::dvec2 p_px{0}, base_px{0}; // of the picture; base: what it is tied to
    glm::dvec2 way_px{0};           // along which it is pulled, unit
    double metres_per_px = 0;       // on the model, along that way
};

// The handles of an incision as they are seen; those behind the eye are left out.
std::vector<IncisionHoldPoint> incision_holds(const NamedIncision& incision, const SeenCut& seen,
                                              const Camera& camera, double scale);
// The one under a pixel, the nearest where there are several.
std::optional<IncisionHoldPoint> incision_hold_at(const std::vector<IncisionHoldPoint>& points,
                                                  glm::dvec2 p_px, double scale);

// A point to which ends are pulled.
struct CutEnd {
    SurfacePoint at_rest;
    glm::dvec3 p_world{0};
};
// The nearest end at most so many pixels away; null: there is none.
const CutEnd* end_near(const std::vector<CutEnd>& ends, const Camera& camera, glm::dvec2 p_px,
                       double within_px);
inline constexpr double end_reach_px = 12; // at scale 1

// A drag, with all as it was when it began.
struct IncisionDrag {
    Id object = 0;
    int number = 1;
    NamedIncision before;
    SeenCut seen;
    IncisedSkin skin;
    IncisionHoldPoint held;
    std::vector<CutEnd> ends; // of other incisions; empty: nothing pulls
    Camera camera;
    glm::dvec2 from_px{0};
    double scale = 1; // of the interface
};
// The command for a hand at `to_px`; with `snap` in round steps. Pure.
EditIncision dragged(const IncisionDrag& drag, glm::dvec2 to_px, bool snap);

// The number of a handle: "Depth 0.05 m".
std::string words_of(IncisionHold hold, const NamedIncision& incision, const SeenCut& seen);

// Points and normals with few digits.
SurfacePoint handy(const SurfacePoint& point);

} // namespace trivar

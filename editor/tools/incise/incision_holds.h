// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/incise.h"
#include "editor/tools/incise/cut_snap.h"

#include <string>

namespace trivar {

// The value that a handle of an incision changes: where an end lies, how far it stands open, how
// deep it is, up to where it is open, where all of it lies.
enum class IncisionHold { none, start, end, open_left, open_right, depth, zip, place };

struct IncisionHoldPoint {
    IncisionHold hold = IncisionHold::none;
    glm::dvec2 p_px{0}, base_px{0}; // of the picture; base: what it is tied to
    glm::dvec2 way_px{0};           // along which it is pulled, unit
    double metres_per_px = 0;       // on the model, along that way
    double share = 0;               // of the length, where it is tied
};

// The handles of an incision as they are seen; those behind the eye are left out. `crossed`: shares
// of its length where others cross it; handles keep away from there where they can.
std::vector<IncisionHoldPoint> incision_holds(const NamedIncision& incision, const SeenCut& seen,
                                              const Camera& camera, double scale,
                                              std::span<const double> crossed = {});
// The one under a pixel, the nearest where there are several.
std::optional<IncisionHoldPoint> incision_hold_at(const std::vector<IncisionHoldPoint>& points,
                                                  glm::dvec2 p_px, double scale);

// A drag, with all as it was when it began.
struct IncisionDrag {
    Id object = 0;
    int number = 1;
    NamedIncision before;
    SeenCut seen;
    IncisedSkin skin;
    IncisionHoldPoint held;
    CutSnaps snaps; // other incisions; empty: nothing pulls
    Camera camera;
    glm::dvec2 from_px{0};
    double scale = 1; // of the interface
};
// The command for a hand at `to_px`; with `snap` in round steps. Pure.
EditIncision dragged(const IncisionDrag& drag, glm::dvec2 to_px, bool snap);

// Returns the edit for a typed number, in the unit that words_of() shows: percent or metres in the
// world. Nothing: its handle has no number.
std::optional<EditIncision> typed_in(const IncisionDrag& drag, double number);
// Whether a typed number is a length; else it is plain.
bool types_length(IncisionHold hold);

// A stroke moved over the skin, so that a point of it comes to another; nothing: a part of it would
// leave the skin. `reach`: how far the skin may be from where a plain turn takes it, metres there.
std::optional<std::vector<SurfacePoint>> moved_over(const IncisedSkin& skin,
                                                    const std::vector<SurfacePoint>& stroke,
                                                    const SurfacePoint& from,
                                                    const SurfacePoint& to, double reach);

// The number of a handle: "Depth 0.05 m".
std::string words_of(IncisionHold hold, const NamedIncision& incision, const SeenCut& seen);

// Points and normals with few digits.
SurfacePoint handy(const SurfacePoint& point);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/cutting/incise.h"
#include "editor/hands/handles.h"
#include "editor/tools/incise/incision_snap.h"

namespace trivar {

// A TakenIncision is an incision as it lay when a hand took one of its handles.
struct TakenIncision {
    Id object = 0;
    int number = 1;
    Document before;
    SeenIncision seen;
    IncisedSkin skin;
    IncisionSnaps snaps; // other incisions; empty: nothing pulls
    const Incising& incising() const { return *trivar::object(before, object).incising; }
};
using TakeIncision = std::function<std::optional<TakenIncision>()>; // nothing: it is gone

// The handles of an incision, by the kinds of their keys: "place" of all of it; "start" and
// "end"; "left" and "right", how far it stands open; "depth"; "zip", up to where it is open. Those
// behind the eye are left out.
// `shown`: opened as far as a blade opens it now. `now`: as the document has it.
// `crossed`: shares of its length where others cross it; handles keep away from there if they can.
// `scale`: of the interface.
// `take`: tells how it lies when a handle is taken; nothing: it is gone.
std::vector<Handle> incision_handles(const NamedIncision& shown, const NamedIncision& now,
                                     const SeenIncision& seen, const Camera& camera, double scale,
                                     std::span<const double> crossed, const TakeIncision& take);

// A stroke moved over the skin, so that a point of it comes to another; nothing: a part of it would
// leave the skin. `reach`: how far the skin may be from where a plain turn takes it, metres there.
std::optional<std::vector<SurfacePoint>> moved_over(const IncisedSkin& skin,
                                                    const std::vector<SurfacePoint>& stroke,
                                                    const SurfacePoint& from,
                                                    const SurfacePoint& to, double reach);

// Points and normals with few digits.
SurfacePoint handy(const SurfacePoint& point);

} // namespace trivar

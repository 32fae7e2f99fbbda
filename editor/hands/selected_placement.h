// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

// The selected object, if it is the only one, lies on a stroke, is visible and not locked; else
// null.
const EvaluatedObject* selected_placement(const Session& session);
// The same for any volume: that of a placed object, or of a lattice.
const EvaluatedObject* selected_volume(const Session& session);

// A NearestLine is the place along the stroke at which the middle line of the strip comes nearest
// to a pixel, and the distance.
struct NearestLine {
    double u = 0, distance_px = 1e300;
};
NearestLine nearest_on_line(const Placement& placement, const Camera& camera, glm::dvec2 p_px);

} // namespace trivar

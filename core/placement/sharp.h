// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/creases.h"
#include "core/rays/ray_scene.h"

#include <optional>

namespace trivar {

// Adds the creases of the scene to a strip. Creases within 10 degrees of u or v become lines of the
// parameters, with order - 1 knots: the nodes of every line across are moved, so that one node lies
// on the crease. Spans with oblique creases are cut into four, or into two where four would give
// too many nodes; their points and the scene's vertices there become `features`. A volume along
// normals takes ridges only: in a valley its sides would meet. Empty if the scene is smooth, or
// rough everywhere. Schein 2006, 2.6.
std::optional<StripLayout> sharpened(const StripLayout& strip, const View& view,
                                     const RayScene& scene, const PlacementParameters& parameters);

// Moves control points along their lines of sight, no more than needed, until the surface is near
// the points in least squares; points that it does not cover are left out.
Surface<glm::dvec3> drawn_to(Surface<glm::dvec3> contact, const View& view,
                             const std::vector<SceneSample>& features, double clearance);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// Whether the spline may have a crease at the abscissa of a control point: order - 1 knots stand
// there, and the control point lies on the spline.
bool creased(const Knots& knots, int control_point);

// Whether values on the grid turn so sharply along `direction` (one per node) that a surface
// through them would overshoot: a node lies further from the line between its neighbours than half
// of the neighbours' distance seen along the direction. Sharp turns at creases are allowed.
bool jumps(const std::array<Knots, 2>& axes, const std::vector<glm::dvec3>& nodes,
           const std::vector<glm::dvec3>& direction);

// Makes the surface over nodes at the Greville abscissae. It goes through the nodes; if that would
// overshoot, the nodes are its control points, which never overshoots.
//   nodes          v fastest, world
//   through_nodes  false: the nodes are always control points
Surface<glm::dvec3> contact_surface(const std::array<Knots, 2>& axes,
                                    const std::vector<glm::dvec3>& nodes, bool through_nodes);

// The cumulative length of the line through points. A step that runs mostly along its view
// direction counts at most three times its seen length: a cliff is one long step of the stroke, and
// the nodes must not all gather there.
std::vector<double> walked_length(const std::vector<glm::dvec3>& points,
                                  const std::vector<glm::dvec3>& view_direction);

// The parameters at which the cumulative length is the given share of the whole. They are linear
// between the known ones; both ends stay.
std::vector<double> at_length_shares(const std::vector<double>& length,
                                     const std::vector<double>& parameter,
                                     const std::vector<double>& shares);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"
#include "core/placement/profile.h"
#include "core/placement/view.h"
#include "core/spline/surface.h"

namespace trivar {

// How high over the contact surface the floor, the middle and the roof of a volume are, in heights:
// 0, 1/2 and 1 unless it sinks in or rises unevenly.
struct Levels {
    double floor = 0, middle = 0.5, roof = 1;
};
Levels levels_of(const Rise& rise, double contact_level);

// F(u, v, w) = S(u, v) + (g(w) - g(w0)) E(u, v): the contact surface and, on the same axes, how
// far and where to the volume rises over it.
struct Extrusion {
    Surface<glm::dvec3> rise; // E
    int lowered = 0;          // columns whose height the fold guard took down to less than half
    std::vector<double> det;  // of F's Jacobian at the nodes, the least at its three levels
    std::vector<double> area; // |S_u x S_v| at the nodes
    double longest_u = 0;     // |S_u| over the nodes
    double least_det() const;
};

// F1 (offset 0): E = h V, V toward the camera. F2 (offset 1): E = h n, n the normals of S. Between:
// the blend of the two, made unit. `height` gives h for each node, metres. Where the offset would
// fold because S curves tighter than it is high, the height is taken down, and the rise is smoothed
// until it does not at any node. The rise of an extrusion is positive throughout: where a spline
// through the heights asked for would not be, they are its control points. Schein 2006, 2.3.1.
Extrusion extrusion(const Surface<glm::dvec3>& contact, const View& view,
                    const std::vector<double>& height, double offset, bool through_nodes,
                    const Levels& levels = {});

// Control points S_ij + (g_k - g(w0)) E_ij: exactly linear in w where g is w itself, whatever the
// order, and S at the contact level w0.
Lattice volume_over(const Surface<glm::dvec3>& contact, const Surface<glm::dvec3>& extruded,
                    const Knots& above, const Rise& rise, double contact_level);

} // namespace trivar

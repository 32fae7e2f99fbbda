// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"
#include "core/placement/profile.h"
#include "core/placement/view.h"
#include "core/spline/surface.h"

namespace trivar {

// Levels holds the heights of a volume's floor, middle and roof over the contact surface, in units
// of its height: 0, 1/2 and 1 unless the volume sinks in or rises unevenly.
struct Levels {
    double floor = 0, middle = 0.5, roof = 1;
};
Levels levels_of(const Rise& rise, double contact_level);

// An Extrusion is the surface E in F(u, v, w) = S(u, v) + (g(w) - g(w0)) E(u, v): for each place of
// the contact surface S, how far and in which direction the volume rises over it.
struct Extrusion {
    Surface<glm::dvec3> rise; // E
    // number of columns that the fold guard lowered to less than half of their height
    int lowered = 0;
    std::vector<double> det;  // of F's Jacobian at the nodes, the least of its three levels
    std::vector<double> area; // |S_u x S_v| at the nodes
    double longest_u = 0;     // greatest |S_u| of the nodes
    double least_det() const;
};

// Makes the extrusion. F1 (offset 0): E = h V, V toward the camera. F2 (offset 1): E = h n, n the
// normals of S. An offset between 0 and 1 blends the two and makes the result unit. Schein 2006,
// 2.3.1.
//   contact        S
//   height         h of each node, metres
//   through_nodes  as for contact_surface()
//   levels         at which folds are looked for
// Where the offset would fold because S curves more tightly than it is high, the height is reduced,
// and the rise is smoothed until no node folds. The rise is positive throughout: where a spline
// through the heights would not be, the heights are its control points.
Extrusion extrusion(const Surface<glm::dvec3>& contact, const View& view,
                    const std::vector<double>& height, double offset, bool through_nodes,
                    const Levels& levels = {});

// The volume with control points S_ij + (g_k - g(w0)) E_ij. It is exactly linear in w where g is w
// itself, for any order, and equals S at the contact level w0.
Lattice volume_over(const Surface<glm::dvec3>& contact, const Surface<glm::dvec3>& extruded,
                    const Knots& above, const Rise& rise, double contact_level);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/placement/section.h"

namespace trivar {

// A Band is a closed way round the Z axis of a surface: a circle, and the surface to both sides of
// it.
struct Band {
    enum class Of { cylinder, sphere, torus, moebius };
    Of of = Of::cylinder;
    double radius = 0.5, tube = 0; // metres; tube: of the torus
    // position across: metres along the surface from its widest circle; twisted bands: 0 only
    double level = 0;
    glm::dmat4 to_world{1};

    bool twisted() const { return of == Of::moebius; }
    // The surface at an angle round the axis and a length across, to the left of the way; for
    // twisted bands p(angle + 2 pi, across) = p(angle, -across).
    glm::dvec3 at(double angle, double across) const;
    // The surface's unit normal there, outwards; on twisted bands it is reversed after one round.
    glm::dvec3 normal(double angle, double across) const;
};

// Makes a volume over a band, closed as the band is: u goes round once, v across it from right to
// left, w along the normals. On a twisted band the surface lies in the middle of the volume, w =
// 1/2, for after one round the model walks on the band's other side.
//   parameters  those used: sizes, profiles, the contact level (not on twisted bands), grid,
//               orders, start, fill and the turn of the model
//   model       box of the model, which stands on the surface with its +z up and +x along the way
// The grid interpolates, so the error falls with the order'th power of the spacing. O(#control
// points). Throws Rejected for a mirrored matrix, for a strip wider than its surface, and for a
// height across, a height map or a rise round a twisted band; a volume that folds says so in its
// report.
Placement place_round(const Band& band, const PlacementParameters& parameters, const Box& model);

// Makes a volume round any body, where a plane cuts it: u is the share of the length of the way.
// Lines across have the width along the surface. Between its nodes too the contact surface stays in
// front of the taut surface of the section, within the tolerance of the lift where that can be; the
// report says what stands out. Throws Rejected for a strip that is wider than the body.
Placement place_round(Section section, const PlacementParameters& parameters, const Box& model);

} // namespace trivar

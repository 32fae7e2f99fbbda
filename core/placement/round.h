// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"

namespace trivar {

// A closed way round the Z axis of a surface: a circle, and how the surface goes on to its sides.
struct Band {
    enum class Of { cylinder, sphere, torus, moebius };
    Of of = Of::cylinder;
    double radius = 0.5, tube = 0; // metres; tube: of the torus
    double level = 0;              // across: metres along the surface from its widest circle;
                                   // twisted bands have none but 0
    glm::dmat4 to_world{1};

    bool twisted() const { return of == Of::moebius; }
    // The surface at an angle round the axis and a length across, left of the way; of twisted bands
    // p(angle + 2 pi, across) = p(angle, -across).
    glm::dvec3 at(double angle, double across) const;
    // Its unit normal there, outwards; of twisted bands it comes back reversed.
    glm::dvec3 normal(double angle, double across) const;
};

// A volume over a band, closed as the band is: u goes round once, v across it from right to left, w
// along the normals. Of a twisted band the surface lies in the middle of the volume, w = 1/2, for
// after one round the model walks on its other side. The model stands on the surface with its +z
// up and +x along the way, from start * the way on; what it is given of the parameters are sizes,
// profiles, the contact level (twisted bands have none), grid, orders, start, fill and how the
// model is turned. The grid interpolates, so the error falls with the order'th power of the
// spacing. Throws Rejected for what is mirrored, for a strip wider than its surface goes on, and
// for a height across, a height map or a rise round a twisted band; a volume that folds says so in
// its report. O(control points).
Placement place_round(const Band& band, const PlacementParameters& parameters, const Box& model);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/field.h"

namespace make {

struct Grid {
    float step;              // edge length of the quads
    bool symmetric_z = true; // grid lines mirror each other across z = 0
    int relax = 8;           // rounds of smoothing along the surface
};

// The field's zero surface within a box as quads: closed, outward, one vertex per sheet and cell
// of a dual grid, relaxed along the surface and put back on it. The same bits for any number of
// threads. S. Gibson 1998 (surface nets); sheets parted as in G. Nielson 2004 (dual marching
// cubes).
Mesh surface(const Field& field, vec3 lo, vec3 hi, Grid grid);

} // namespace make

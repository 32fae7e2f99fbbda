// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// How a flat region becomes a body. In em.
struct Extrusion {
    double depth = 0.2;
    double bevel = 0;    // how far the front and the back draw in; at most 0.45 of the depth counts
    int bevel_steps = 1; // 1: a flat chamfer; more: a quarter circle
    double max_edge = 0.1; // of all edges of the faces and, bevels apart, of the sides
};

} // namespace trivar

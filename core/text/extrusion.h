// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// An Extrusion says how a flat region becomes a body. All lengths are in em.
struct Extrusion {
    double depth = 0.2;
    double bevel = 0;      // how far front and back are drawn in; at most 0.45 of the depth
    int bevel_steps = 1;   // 1: a flat chamfer; more: a quarter circle
    double max_edge = 0.1; // greatest length of the edges of faces and sides; bevels are excepted
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_drawing.h"

namespace trivar {

// A SkinTriangle is a piece of a triangle of the skin, between points of a SlitDrawing.
struct SkinTriangle {
    std::array<std::uint32_t, 3> points;
    std::uint32_t parent; // triangle of the skin
};

// The pieces of a triangle that a drawing touches: all segments on it are edges of them. The
// drawing is arranged. By a constrained triangulation on the lattice; then edges are turned over
// where that makes the pieces less thin.
std::vector<SkinTriangle> filled(const SlitDrawing& drawing, std::uint32_t triangle);

} // namespace trivar

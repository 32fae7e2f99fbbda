// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_field.h"
#include "core/split/surface_bounds.h"

namespace trivar {

// The bounds of an opening's cut surface and walls, computed once.
struct OpeningBounds {
    explicit OpeningBounds(const Opening& opening);

    SurfaceBounds surface;
    std::array<SurfaceBounds, 2> walls;   // in parts of pieces
    BendBounds surface_bends, wall_bends; // wall_bends: of both, by pieces
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/surface_bounds.h"

namespace trivar {

// The bounds of an opening's cut surface and walls, computed once.
struct OpeningBounds {
    OpeningBounds(const Surface<double>& cut, const Surface<double>& below,
                  const Surface<double>& above)
        : surface(cut, false),
          walls{SurfaceBounds(below, true, 2), SurfaceBounds(above, true, 2)},
          surface_bends({&surface, 1}),
          wall_bends(std::array{SurfaceBounds(below, true), SurfaceBounds(above, true)})
    {
    }

    SurfaceBounds surface;
    std::array<SurfaceBounds, 2> walls;   // in parts of pieces
    BendBounds surface_bends, wall_bends; // wall_bends: of both, by pieces
};

} // namespace trivar

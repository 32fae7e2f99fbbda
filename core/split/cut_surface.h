// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"
#include "core/split/obstacle_columns.h"

namespace trivar {

// A CutSurface is u = phi(v, w): a bicubic spline through the middle of an obstacle, so that a
// leaning or bent obstacle asks for no wider an opening than an upright one. Beyond its domain it
// goes on as it is at the border.
using CutSurface = Surface<double>;

// The least-squares fit, with a small penalty on second differences, to the middles of an
// obstacle's columns; by the penalty it extends smoothly beyond the obstacle's shadow. About 10 ms.
CutSurface middle_surface(const ObstacleColumns& columns);

// The plane u = const through the mean of those middles, over the same domain.
CutSurface middle_plane(const ObstacleColumns& columns);

} // namespace trivar

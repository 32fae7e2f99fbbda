// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/surface_shape.h"
#include "core/lines/more_lines.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// The lines of one kind on a surface.
struct KindLines {
    LineKind kind;
    Silhouettes lines;
};

// Finds the lines of a surface that are the same in every view: ridges and valleys, where the
// greatest of the principal curvatures is greatest along its own direction [Ohtake, Belyaev, Seidel
// 2004]; parabolic lines, where the Gaussian curvature is 0; isophotes, where <n, light> is 0, 1/N,
// 2/N .. for N of them. How distinct a line must be is told relative to the size of the surface.
// 0.3 to 0.8 us per triangle.
std::vector<KindLines> fixed_lines(const SurfaceShape& shape, const MoreLines& wanted);

// Finds suggestive contours: the zeros of the curvature along the sight, at places that face the
// eye, where it grows toward the eye [DeCarlo, Finkelstein, Rusinkiewicz, Santella 2003, 2.2]. The
// view is in the space of the surface. 10 ns per triangle, 0.3 us per point.
Silhouettes suggestive_lines(const SurfaceShape& shape, const ViewPoint& view,
                             const MoreLines& wanted);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/field/field_hulls.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// Silhouettes with a proof of where there are none.
struct CertifiedSilhouettes {
    Silhouettes curves;
    std::size_t cells = 0;  // of the grid that could not be left out
    std::size_t boxes = 0;  // that were looked at
    std::size_t leaves = 0; // boxes of the least size that could not be left out,
    std::size_t open = 0; // and those in which no curve was found: each may hide a piece or a loop
                          // that is smaller than it
    std::size_t loose_ends = 0; // of curves, within the grid; 0 unless rounding hid a leaf
};

// Finds all silhouettes of a level of an interpolating or smoothing cubic field, except for pieces
// that fit into boxes of 2^-depth voxels. Cells and then their halves, along x, y and z in turn,
// are left out if the Bezier net of D - level or that of <V, grad D> has no zero: no silhouette is
// there. In the boxes that remain the level is marched as in level_mesh(), on the lattice of their
// corners. Two boxes that touch see the same numbers at their common corners. An eye needs no other
// bounds: <p - eye, grad D> is of degree 3 in each variable, too.
//   level     in samples
//   view      a direction or an eye, voxels
//   depth     0 .. 5; with 3 or 4 the recall is at least 0.9999 of the length
//   progress  called from any thread
// Throws Rejected if the field is not cubic, depth is out of range or the view is none. The same
// for any number of threads.
CertifiedSilhouettes certified_silhouettes(const ScalarField<float>& field, const FieldHulls& hulls,
                                           float level, const ViewPoint& view, int depth,
                                           const SilhouetteOptions& options = {.spacing = 0.1f},
                                           const Progress& progress = {});

} // namespace trivar

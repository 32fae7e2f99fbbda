// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/simplify/decimation_values.h"

namespace trivar {

// Collapses half-edges of OpenMesh one after another, a node onto a neighbour, as its decimater
// allows it, until the target is met or nothing can be collapsed any more. A collapse costs the sum
// of squared distances from the planes of all triangles for which the node stands, weighted by
// their areas, and from planes along rails that stand on the surface [1]; summed over the poses
// [2]. The cheapest collapse comes first. The tolerance bounds the mean in each pose; a node onto
// which others were collapsed has the least tolerance of them all. No triangle turns over, at rest,
// in a pose or in texture coordinates. Rails keep their ends and never meet; the surface keeps its
// topology. One thread; the same bits every time. O(#T log #T).
//   [1] Garland, Heckbert, Surface simplification using quadric error metrics, 1997
//   [2] Mohr, Gleicher, Deformation sensitive decimation, 2003
Decimation decimated(const Mesh& mesh, const Fans& fans, const NodePlaces& places,
                     const DecimationTarget& target, const Progress& progress = {});

} // namespace trivar

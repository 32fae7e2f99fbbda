// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

namespace trivar {

// Which functions of cells that meet in a face which is not cut share a control point, of those
// that take no knot beyond the first from a corner off the face: those whose knots are stacked on
// their vertices, or in the plane of a seam, so that both jump at the face and their sum does not;
// or all. The control points
// of a polynomial, its polar forms, are the same for all these, so it needs no more.
enum class PointSharing { stacked, all };

// The control point of each basis function, numbered from 0: all multi-indices of the first cell,
// then those of the second one. O(number of cells).
template <int S>
std::vector<int> shared_points(const SimplexDomain<S>& domain,
                               PointSharing sharing = PointSharing::stacked);

} // namespace trivar

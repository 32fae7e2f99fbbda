// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

namespace trivar {

// PointSharing says which basis functions of cells that meet in an uncut face share a control
// point, of those that take no knot beyond the first from a corner off the face. `stacked`: only
// those whose knots coincide with their vertices, or lie in the plane of a seam, so that both jump
// at the face and their sum does not. `all`: every pair with equal knots; a polynomial needs no
// more, for its polar forms are the same for all these.
enum class PointSharing { stacked, all };

// Returns the control point of each basis function, numbered from 0: all multi-indices of the first
// cell, then those of the second one. O(number of cells).
template <int S>
std::vector<int> shared_points(const SimplexDomain<S>& domain,
                               PointSharing sharing = PointSharing::stacked);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

namespace trivar {

// The control point of each basis function, numbered from 0: all multi-indices of the first cell,
// then those of the second one. Functions of cells that meet in a face which is not cut share one
// where each knot beyond the first that they use lies on its vertex, and that vertex on the face.
// Then both jump at the face, and their sum does not. O(number of cells).
template <int S> std::vector<int> shared_points(const SimplexDomain<S>& domain);

} // namespace trivar

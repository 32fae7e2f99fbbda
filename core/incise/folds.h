// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_shape.h"

namespace trivar {

// Points that a drawing lacks where pieces of skin would turn over when all cuts are quite open, as
// they are too long beside a rim to follow the field: each halves the longest side of such a piece
// that is no cut, below the opposite corner. O(#terms). None: there is no such piece, or it is
// small.
std::vector<LatticePoint> points_against_folds(const SlitShape& shape);

} // namespace trivar

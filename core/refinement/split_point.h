// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/error_bounds.h"

namespace trivar {

// The place at which to split an edge, 0.2 to 0.8.
double split_point(ErrorBounds& bounds, const std::array<ErrorBounds::Corner, 2>& edge,
                   SplitPoint split);

} // namespace trivar

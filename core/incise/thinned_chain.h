// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_drawing.h"

namespace trivar {

// A chain as it is drawn: without hooks at its ends, which are slips of the hand, and without
// points that hardly bend it, because they make slivers and no shape. A single segment gets a point
// in its middle, which can open. O(n log n) in its points [Douglas, Peucker 1973].
DrawnChain thinned(const SlitSkin& skin, DrawnChain chain);

} // namespace trivar

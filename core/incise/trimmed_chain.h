// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_drawing.h"

namespace trivar {

// A chain of two points at least without what a hand did not mean: hooks at its ends, and points of
// one triangle that hardly bend it. A single segment gets a point in its middle, which can open.
DrawnChain trimmed(const CutSkin& skin, DrawnChain chain);

} // namespace trivar

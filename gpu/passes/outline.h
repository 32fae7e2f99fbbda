// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/lines.h"

namespace trivar::gpu {

// Draws the outline of outlined items and curves, under all curves that are seen; in a draft it
// costs a third and is rougher.
void draw_outline(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
                  const LinePass& curves, const LinePass& all_curves, const Outline& outline,
                  bool draft);

} // namespace trivar::gpu

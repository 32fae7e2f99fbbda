// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluated.h"
#include "gpu/curve.h"

#include <vector>

namespace trivar {

// What the renderer draws of an object's curves: one for each part of them and material, in the
// material's colour times that of their points. Something solid hides them. O(#points), and where a
// volume bends them and nobody asked before, what that takes the processor.
std::vector<gpu::Curve> curves_of(const EvaluatedObject& object, float width_px);

} // namespace trivar

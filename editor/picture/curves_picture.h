// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"
#include "gpu/curve.h"

#include <vector>

namespace trivar {

// The renderer's curves for an object: one per curve part and material, in the material's colour
// times that of the points. Solid things hide them. O(#points), and the time of deforming them
// where a volume does and nobody has asked before.
std::vector<gpu::Curve> curves_of(const EvaluatedObject& object, float width_px);

} // namespace trivar

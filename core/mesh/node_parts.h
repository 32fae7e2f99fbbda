// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/clip.h"

#include <optional>

namespace trivar {

// Gives the parts of an affine matrix; empty where parts cannot express it, for example where it
// shears. Of a matrix that mirrors, the scale along x is below 0.
std::optional<NodeTransform> as_parts(const glm::dmat4& matrix);

} // namespace trivar

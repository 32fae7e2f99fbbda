// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "gpu/picture.h"

namespace trivar {

// The colour of a tile whose height is that share of the one up to which it is proven not to fold:
// grey where it is far from it, amber near it, red from it on. Display-linear.
glm::vec3 limit_color(double share);

// Shows the tiles of a layer in these colours in place of its materials.
void color_by_limits(gpu::Picture& picture, Id layer);

} // namespace trivar

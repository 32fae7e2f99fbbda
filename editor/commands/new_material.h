// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace trivar {

// The look of a primitive until it gets a material: a middle grey, which leaves room for light and
// for shade.
inline const Surfacing new_material{.base_color = {0.5f, 0.5f, 0.5f, 1}};

} // namespace trivar

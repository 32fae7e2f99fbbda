// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaper.h"

#include <string>
#include <vector>

namespace trivar {

// Adds one sentence per step of shaping that gave nothing.
void tell_of_steps(const ShapedVolume& shaped, std::vector<std::string>& notices);

} // namespace trivar

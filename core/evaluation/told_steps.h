// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaper.h"

#include <string>
#include <vector>

namespace trivar {

// Adds why single steps of shaping gave nothing, a sentence each.
void tell_of_steps(const ShapedVolume& shaped, std::vector<std::string>& notices);

} // namespace trivar

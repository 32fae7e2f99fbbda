// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/incise.h"

namespace trivar::testing {

// A stroke on the unit sphere through directions, straight between them.
Incision cut_on_sphere(const std::vector<glm::dvec3>& through, double depth = 0.1,
                       double width = 0.1);
// Two that cross at (1, 0, 0).
std::vector<Incision> crossing_cuts_on_sphere();

} // namespace trivar::testing

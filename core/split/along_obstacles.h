// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_field.h"

namespace trivar {

// Returns the frame turned about u until w goes along obstacles that together are a bar, whether it
// leans or not: a skin drawn in along w is then drawn along the bar. Unchanged: they are none, or
// lie more along v. O(#V of the obstacles).
SplitFrame along_obstacles(const std::vector<SplitObstacle>& obstacles, SplitFrame frame);

} // namespace trivar

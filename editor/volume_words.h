// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"

#include <string>

namespace trivar {

// What a step of shaping is, for a list: "Press, Gaussian 0.34 m".
std::string words_of(const VolumeEdit& edit);

// How many control points of an axis are left where they are made a quarter fewer.
int fewer_points(const Knots& axis);

} // namespace trivar

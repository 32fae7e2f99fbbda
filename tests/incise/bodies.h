// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_skin.h"

namespace trivar::testing {

SlitSkin skin_of(Mesh mesh); // vertices at one place are one point
Mesh icosphere(int halvings);
Mesh shell_mesh(int halvings, double inner); // a hollow ball of radius 1, in two skins
Mesh any_closed_primitive(std::size_t i);    // 0, 1, ...: sphere, torus, box, cylinder, icosphere

} // namespace trivar::testing

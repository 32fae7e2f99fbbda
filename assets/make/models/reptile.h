// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/loft.h"

namespace make {

// The height by which its trunk rises when it stands on its legs instead of lying on its belly.
inline constexpr float reptile_rise = .013f;

// A skin for the root's mesh and the clip "walk": it trots, its spine bending from side to side.
// The limbs of the side z > 0, as they are in the mesh.
void crawl(Model& model, const Limb& fore, const Limb& hind);

} // namespace make

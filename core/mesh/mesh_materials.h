// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Adds `first` to the materials that the faces index, so that they index a longer list in which
// their own begin there. O(#F).
Mesh with_materials_from(Mesh mesh, std::uint32_t first);

} // namespace trivar

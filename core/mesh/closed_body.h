// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Whether the faces are the skins of solid bodies: along every edge between two points as many
// faces run one way as the other, and the faces of each connected piece look outwards. From outside
// of all bodies only the fronts of faces can then be seen. False where there are no faces. O(#C log
// valence).
bool is_closed_body(const Mesh& mesh);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace trivar {

// The mesh with a texture coordinate for each corner (#C) as its only set. A vertex whose corners
// have several becomes as many vertices, one behind the other; `points` is left empty.
Mesh with_corner_uvs(const Mesh& mesh, const std::vector<glm::vec2>& uvs);

} // namespace trivar

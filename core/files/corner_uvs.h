// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace trivar {

// The mesh with one texture coordinate per corner (#C) as its only set. A vertex whose corners have
// several becomes as many consecutive vertices; `points` is left empty.
Mesh with_corner_uvs(const Mesh& mesh, const std::vector<glm::vec2>& uvs);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Repeats a mesh, one copy behind the other. Positions, normals and tangents have the size for all
// copies and are to be written by the caller; faces and all else are there. `mirrored` turns the
// faces round. O(#copies (#V + #C)).
Mesh copies_of(const Mesh& mesh, std::size_t copies, bool mirrored);

} // namespace trivar

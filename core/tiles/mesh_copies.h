// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Repeats a mesh so many times, one copy behind the other, with positions, normals and tangents
// still to be written: they are there in number. `mirrored` turns the faces round.
Mesh copies_of(const Mesh& mesh, std::size_t copies, bool mirrored);

} // namespace trivar

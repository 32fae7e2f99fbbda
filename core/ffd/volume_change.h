// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"

namespace trivar {

// By which factor a lattice changes the volume at every vertex of the mesh that is put into it,
// from object space to the world: det J. Less than 0: folded over. #V; about a microsecond a vertex
// on one thread.
std::vector<float> volume_change(const Mesh& mesh, const Embedding& embedding,
                                 const Lattice& lattice);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref_pool.h"
#include "core/incise/incised.h"
#include "core/incise/slit_shape.h"

namespace trivar {

// Makes the mesh of cuts that are shut: the original's faces except those of the patch, then the
// pieces of skin, then the walls. New vertices of the skin have the blended attributes of the face
// that they lie on; walls have vertices of their own, with texture coordinates (length along the
// cut, depth) in units of the mesh. Fills `rest`, which `made` lends, the terms and the lists of
// moving vertices.
void make_rest(IncisedMesh& incised, const SlitShape& shape, std::span<const Incision> incisions,
               std::span<const int> borders, std::span<const WallLayer> layers,
               RefPool<Mesh>& made);

} // namespace trivar

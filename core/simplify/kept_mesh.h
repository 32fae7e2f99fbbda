// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplify/decimation.h"

namespace trivar {

// The mesh of the triangles that are left, in their order. Polygons none of whose triangles changed
// stay polygons. A vertex keeps all values but its normal, which is taken anew from the faces where
// they changed: a mean weighted by area, or the face's own where it is shaded flat; a node whose
// normals were split by a hard edge keeps them. O(#C).
Mesh kept_mesh(const Mesh& mesh, const Fans& fans, const Decimation& left);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplify/decimation.h"

namespace trivar {

// The mesh of the remaining triangles, in their order. A polygon of which no triangle changed stays
// a polygon. A vertex keeps all values but its normal, which is computed anew where its faces
// changed: a mean weighted by area, or the face's own where it is shaded flat. A node whose normals
// were split by a hard edge keeps them. O(#C).
Mesh kept_mesh(const Mesh& mesh, const Fans& fans, const Decimation& left);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace trivar {

// Subdivides a cage by Catmull and Clark, `levels` times (0..6). Creases and corners are kept; the
// last level is moved to its limit position and has limit normals. Texture coordinates are
// face-varying: seams stay seams. Throws Rejected if the result would exceed 20 million faces. E.
// Catmull, J. Clark 1978; creases after DeRose, Kass, Truong 1998.
Mesh subdivide(const Mesh& cage, int levels, const Progress& progress = {});

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

#include <map>

namespace make {

using Sharpness = std::map<std::pair<int, int>, float>; // keyed by the smaller index first

// Catmull-Clark subdivision of one cage without texture coordinates; free edges are sharp.
// E. Catmull, J. Clark 1978; semi-sharp creases after DeRose, Kass, Truong 1998.
Mesh catmull_clark(const Mesh& cage, const Sharpness& creases = {}, int levels = 1);

} // namespace make

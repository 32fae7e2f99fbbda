// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/mesh.h"

#include <map>

namespace make {

using Sharpness = std::map<std::pair<int, int>, float>; // keyed by the smaller index first

// Catmull-Clark subdivision of one cage without texture coordinates, as the editor subdivides one:
// free edges are sharp, the points are those of the limit surface.
Mesh catmull_clark(const Mesh& cage, const Sharpness& creases = {}, int levels = 1);

} // namespace make

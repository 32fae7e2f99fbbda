// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/plane/loops.h"
#include "core/text/extrusion.h"

#include <optional>

namespace trivar {

// A closed body over z = 0 .. depth, in em, with triangles in front and behind and quads round the
// sides. Its front is a height over the region: rings are inset by the bevel's profile, each at its
// height, so that the front stays flat where a stroke is too narrow for the next ring, and no bevel
// crosses another. Normals follow curves and break at corners of more than 40 degrees. Texture
// coordinates are lengths in em: x and y in front, -x and y behind, along the edge and z on the
// sides. `points` tells bodies apart that touch. Empty: the region is too fine for the grid, or has
// no area.
std::optional<Mesh> letter_body(const Region& region, const Extrusion& extrusion);

} // namespace trivar

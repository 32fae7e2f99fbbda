// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/silhouette/level_mesh.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// Finds where a level leaves its grid: the closed curves round what the faces of the grid cut off,
// the same for all views. Their bend is 0. O(#triangles).
Silhouettes border_lines(const ScalarField<float>& field, const LevelMesh& level,
                         float spacing = 0.4f);

} // namespace trivar

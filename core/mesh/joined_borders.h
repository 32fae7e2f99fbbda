// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A mesh whose borders are joined where their points lie at one place, up to a few units in the
// last place of its largest coordinate. Only ends of edges with a single face are joined, so that
// bodies that touch stay apart, and no corners of one face, so that narrow faces stay; joined
// points get one position and one number.
struct JoinedBorders {
    Mesh mesh;
    bool any = false; // false: the mesh is the one that was given
};
// `border` holds the points at the ends of such edges; they may repeat. O(#V + n log n).
JoinedBorders with_joined_borders(Mesh mesh, std::vector<std::uint32_t> border);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_error.h"

namespace trivar {

// The mesh with the triangles near the openings of a field split, at the middles of their edges,
// until none is off by more than the tolerance (metres), or until `most_triangles` are there.
// Positions are in the world. Faces are triangles then; triangles that were not split keep their
// order and stand first. The mesh itself where nothing needs it. No cracks: an edge is split for
// both of its triangles.
Mesh fine_enough(const Mesh& mesh, const SplitField& field, const SplitError& error,
                 double tolerance, std::size_t most_triangles);

} // namespace trivar

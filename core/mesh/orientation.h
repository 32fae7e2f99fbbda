// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_edges.h"

namespace trivar {

// TurnedFaces counts the turns of orient(): single faces, and closed parts that were inside out as
// a whole.
struct TurnedFaces {
    std::size_t faces = 0, inside_out = 0;
};

// Turns the faces of a mesh round as repaired() says (core/mesh/repair.h). `edges` are those of the
// mesh.
TurnedFaces orient(Mesh& mesh, const FaceEdges& edges);

} // namespace trivar

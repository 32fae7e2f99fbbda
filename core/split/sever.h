// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/split/cut_sheet.h"

#include <optional>

namespace trivar {

struct SeverOptions {
    // Units of the cut's space: no point of the cut is further from a curved surface than that, as
    // long as there are at most that number of triangles.
    double tolerance = 1e-3;
    std::size_t most_triangles = 4000000;
    bool capped = true;         // closed with caps; otherwise the halves are open
    std::uint32_t material = 0; // face_material of the caps
};

// Severed is a mesh that was cut in two: below and above. A half may have no faces.
struct Severed {
    std::array<Mesh, 2> halves;
    std::size_t fans = 0, open = 0, gaps = 0; // see Caps
    double off = 0; // units of the cut's space: bound of the distance of the cut from the surface
};

// An Unsevered says on which side of a surface a mesh lies that the surface does not part.
struct Unsevered {
    bool above = true;
    bool touched = false; // a face, an edge or a corner of it lies on the surface
};

// Cuts a mesh along a surface and closes both halves. A curved surface is met by triangles that are
// fine enough there. Points no further from the surface than a millionth of the mesh's size, or
// than their numbers can tell, lie on it: a face there belongs to one side, and no half is thinner.
// Vertices that are not on the cut keep their bits and their order. Morph targets go along; those
// of caps come from their rims. Nothing: the whole mesh is on one side, which `unsevered` tells.
std::optional<Severed> sever(const Mesh& mesh, const CutSheet& sheet, const SeverOptions& options,
                             Unsevered& unsevered);

} // namespace trivar

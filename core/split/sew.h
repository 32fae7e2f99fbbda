// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cap.h"
#include "core/split/seam.h"

namespace trivar {

// Joins both halves where an opening ends: copies of a place beyond the walls become one point, and
// triangles of both caps between such points, which lie on each other, are left out; so are caps
// that lie inside, away from the rim, as round an obstacle that is hidden in the mesh. A closed
// mesh stays closed, and a sheet is one sheet before and behind the obstacle. Only caps beside the
// obstacle remain. O(size of the cut).
void sew(CutMesh& cut, const Caps& caps, const SplitField& field, std::size_t opening);

// Returns the edges of a triangle of a cap that reaches beyond an opening, as shares of the length
// that is allowed there if the part beyond is to be left out; 0: it does not reach beyond.
std::array<double, 3> reach_beyond(const std::array<glm::dvec2, 3>& vw, const Opening& opening);

// Moves a vertex that is drawn in by seams and parted by the field: its position, normal and
// tangent.
void move_sewn(Mesh& mesh, std::size_t vertex, const SplitField& field, std::span<const Seam> seams,
               std::span<const char> sides, std::span<const char> on);

} // namespace trivar

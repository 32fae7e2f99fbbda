// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/mesh.h"

#include <vector>

namespace trivar {

// A TileLevel is a tile with fewer triangles, in its unit cell.
struct TileLevel {
    Ref<Mesh> mesh;
    double error = 0; // how far it is from the first level, about, in sides
};

// Makes levels by core/simplify, the first of them the mesh itself, each with about half of the
// triangles of the one before; the errors never fall. They are measured at some hundred vertices of
// the mesh and not proven: they decide how small a tile must be to be drawn so. About 20
// microseconds per triangle.
std::vector<TileLevel> levels_of(const Ref<Mesh>& mesh);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/limit_surface.h"

#include <random>

namespace trivar::testing {

Mesh torus_cage();     // 12 x 6 quads, all vertices regular
Mesh cube_cage();      // 2 x 2 quads a side, eight vertices of valence 3
Mesh tower_cage();     // pentagons, quads and triangles
Mesh open_box_cage();  // creases of many sharpnesses, a sharp corner and a border
Mesh sharp_box_cage(); // a box of side 2 whose edges and corners are infinitely sharp
Mesh plane_cage();     // 4 x 3 quads in z = 0, from -1 to 1
struct NamedCage {
    const char* name;
    Mesh mesh;
};
std::vector<NamedCage> all_cages();

LimitSurface limit_of(const Mesh& mesh);
// A limit surface that is the unit sphere within 1e-5, but within 2e-4 at its eight vertices of
// valence 3.
const LimitSurface& limit_sphere();

ChartPlace random_chart_place(const LimitSurface& surface, std::mt19937& random);
// Unit.
glm::dvec3 random_tangent_at(const LimitSurface& surface, const ChartPlace& at,
                             std::mt19937& random);

} // namespace trivar::testing

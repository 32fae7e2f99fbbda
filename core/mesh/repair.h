// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace trivar {

// Repairs counts the damage by kind.
struct Repairs {
    std::size_t repeats = 0;    // faces whose corners repeated a point
    std::size_t dropped = 0;    // faces left with fewer than three corners
    std::size_t doubled = 0;    // faces with the same corners as another one
    std::size_t turned = 0;     // faces turned round, without those of
    std::size_t inside_out = 0; // closed parts that were turned as a whole
    std::size_t loose = 0;      // vertices that no face uses
    Repairs& operator+=(const Repairs& other);
};

// One sentence per kind of damage, with its number; empty where nothing was damaged.
std::vector<std::string> sentences(const Repairs& repairs);

struct RepairedMesh {
    Mesh mesh;
    Repairs repairs;
};

// Repairs harmless damage of a mesh whose indices are in range: corners that repeat the point
// before them, faces with fewer than three different corners, faces that have the places, the
// direction and the material of another one, borders that lie at one place
// (core/mesh/joined_borders.h), vertices that no face uses, and
//  - faces turned against the rest of their component (where that can be turned consistently at
//  all:
//    a Moebius band stays as it is). In a mesh with such faces every component shows outside what
//    is seen more of its front; where that is not clear, most of its faces stay as they were;
//  - closed components of negative volume, unless other faces hide them: cavities stay.
// Normals that then look into their faces are turned with them. O(#C log valence), and 14 pictures
// (core/mesh/outside.h) where components have to be looked at.
RepairedMesh repaired(Mesh mesh);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace trivar {

// Repairs counts what was damaged.
struct Repairs {
    std::size_t repeats = 0; // faces whose corners repeated a point
    std::size_t dropped = 0; // faces left with fewer than three corners
    std::size_t turned = 0;  // faces turned round
    std::size_t loose = 0;   // vertices that no face uses
    Repairs& operator+=(const Repairs& other);
};

// One sentence per kind of damage, with its number; empty where nothing was damaged.
std::vector<std::string> sentences(const Repairs& repairs);

struct RepairedMesh {
    Mesh mesh;
    Repairs repairs;
};

// Repairs harmless damage of a mesh whose indices are in range: corners that repeat the point
// before them, faces with fewer than three different corners, vertices that no face uses, and faces
// turned against the rest of their component (where the component can be turned consistently at
// all: a Moebius band stays as it is). O(#C log valence).
RepairedMesh repaired(Mesh mesh);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace trivar {

struct Repaired {
    Mesh mesh;
    std::vector<std::string> notices; // a sentence for each kind of damage found, empty: untouched
};

// Takes the harmless damage out of a mesh whose indices are in range: corners that repeat the
// point before them, faces left with fewer than three different ones, vertices no face has, and
// faces turned against the rest of their component (where the component can be turned consistently
// at all: a Moebius band stays as it is). O(#C log valence).
Repaired repaired(Mesh mesh);

} // namespace trivar

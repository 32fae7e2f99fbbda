// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplify/fans.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// The places of the nodes, at rest and in each pose, relative to the middle of all nodes.
using NodePlaces = std::vector<std::vector<glm::dvec3>>; // each #N

struct DecimationTarget {
    std::size_t triangles = 0; // number at which to stop; triangles that are left out do not count
    std::vector<double> tolerance; // #N, or empty: none. Root mean square distance, see below
};

struct Decimation {
    // #T as in Fans; nodes.x is `none` for a removed triangle
    std::vector<glm::uvec3> triangles, nodes;
    std::vector<bool> changed;       // #T: a corner moved to another node
    std::vector<Fans::Rail> creases; // the rails with a sharpness that are left
    std::size_t count = 0;           // number of triangles that are neither removed nor left out
};

inline bool is_gone(const Fans& fans, const Decimation& left, std::size_t triangle)
{
    return fans.nodes[triangle].x != Fans::none && left.nodes[triangle].x == Fans::none;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplify/fans.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// Where the nodes stand, once at rest and once in each pose; about the middle of them all.
using NodePlaces = std::vector<std::vector<glm::dvec3>>; // each #N

struct DecimationTarget {
    std::size_t triangles = 0;     // to stop at, of those that are not left out
    std::vector<double> tolerance; // #N, or empty: none. Root mean square distance, see below
};

struct Decimation {
    std::vector<glm::uvec3> triangles, nodes; // #T as of Fans; nodes.x is `none` for what is gone
    std::vector<bool> changed;                // #T: a corner went elsewhere
    std::vector<Fans::Rail> creases;          // those rails with a sharpness that are left
    std::size_t count = 0;                    // of triangles that are neither gone nor left out
};

inline bool is_gone(const Fans& fans, const Decimation& left, std::size_t triangle)
{
    return fans.nodes[triangle].x != Fans::none && left.nodes[triangle].x == Fans::none;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// An Embedding says how an object lies in a lattice. Both maps are affine, from object space.
struct Embedding {
    glm::dmat4 to_uvw{1};
    glm::dmat4 to_rest{1}; // rest(to_uvw(p)): world before deformation, often known exactly

    bool operator==(const Embedding&) const = default;
};

} // namespace trivar

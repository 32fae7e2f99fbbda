// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A BirthVertex is a new vertex whose attributes are a mean of those of up to three vertices, or
// that stands in a wall: then its colour is white, and its texture coordinates are its own.
struct BirthVertex {
    glm::uvec3 of{0};
    glm::dvec3 weights{1, 0, 0};
    std::uint32_t point = 0; // its number in Mesh::points
    glm::vec3 position{0};
    bool wall = false;
    glm::vec2 uv{0}; // of a wall
};

// Appends new vertices to the arrays of `mesh` from those that it had; Mesh::points is not empty.
// Morph targets move a wall as the skin above it.
void add_births(Mesh& mesh, const std::vector<BirthVertex>& births);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/key_numbers.h"
#include "core/level/level_mesh.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// BorderEdges are the edges of a level in the faces of its grid, slab by slab, and the closed lines
// that they make.
class BorderEdges {
public:
    // Adds those of a mesh's first bricks; its vertices are numbered from `first_vertex` on.
    void add(const ScalarField<float>& field, const LevelMesh& level, std::size_t bricks,
             std::uint32_t first_vertex);
    // Leaves it empty.
    Silhouettes lines(float spacing);

private:
    struct Edge {
        std::uint32_t from, to;
        glm::vec3 p; // at its begin
        float slope; // of the field there
    };
    std::vector<Edge> edges_;
    KeyNumbers known_;
};

// Finds where a level leaves its grid: the closed curves round the sections in the faces of the
// grid, the same for all views. Their bend is 0. O(#triangles).
Silhouettes border_lines(const ScalarField<float>& field, const LevelMesh& level,
                         float spacing = 0.4f);

} // namespace trivar

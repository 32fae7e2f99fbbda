// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field/field_hulls.h"
#include "core/silhouette/edge_chains.h"
#include "core/silhouette/silhouettes.h"

#include <array>

namespace trivar {

// A LeafMarch is the result of marching the leaves of one or more bricks: vertices, with keys by
// which other bricks know those in a brick's faces, and crossed triangles by these vertices.
struct LeafMarch {
    struct Shared {
        std::uint32_t vertex;
        std::uint64_t key;
    };
    std::vector<glm::vec3> positions;
    std::vector<float> product; // <V, grad D>, by vertex
    std::vector<Shared> shared;
    std::vector<CrossedTriangle> triangles;
    std::size_t cells = 0, boxes = 0, leaves = 0, open = 0; // see CertifiedSilhouettes
};

// LeafMarcher marches leaves, brick by brick, on a lattice of 2^depth points a voxel. D and
// <V, grad D> are evaluated once at each point of it, from its whole numbers alone.
class LeafMarcher {
public:
    LeafMarcher(const ScalarField<float>& field, float level, const ViewPoint& view, int depth);

    // Goes to the brick whose first cell is this.
    void begin(const glm::ivec3& first_cell);
    // Adds the leaf whose lower corner is this lattice point, from the brick's first cell on.
    void add(const glm::ivec3& leaf, LeafMarch& out);

private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    struct Corner {
        std::size_t at;                      // lattice point of the brick
        float above, product;                // D - level and <V, grad D>
        std::array<std::uint32_t, 8> vertex; // by direction
    };
    std::uint32_t corner(const glm::ivec3& at);
    std::uint32_t vertex(const glm::ivec3& corner_at, int direction, std::uint32_t from,
                         std::uint32_t to, LeafMarch& out);

    const ScalarField<float>& field_;
    float level_;
    ViewPoint view_;
    int per_voxel_, side_; // lattice points per voxel, and along a brick
    glm::ivec3 origin_{0}; // lattice point
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> number_; // of corners, by lattice point of the brick
};

} // namespace trivar

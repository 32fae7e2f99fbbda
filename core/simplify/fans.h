// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A mesh as decimation wants it: triangles whose edges have one or two of them, and nodes. A node
// is a fan of triangles round a point of the surface; where several fans touch in a point it has
// several nodes.
struct Fans {
    static constexpr std::uint32_t none = ~0u;
    // A line of edges that stays one: a border, a crease, or where the two sides differ in
    // material, group, texture coordinates, colours, influences or the direction of their normals.
    struct Rail {
        std::uint32_t a, b; // nodes
        float sharpness;    // of the crease, 0: none
    };
    std::vector<std::uint32_t> first_equal; // #V: one stands for all of a point with equal values
    std::vector<glm::uvec3> triangles;      // #T to such vertices
    std::vector<std::uint32_t> face;        // #T to the face that it is a piece of
    std::vector<glm::uvec3> nodes;          // #T; `none` for a triangle that is left out
    std::vector<std::uint32_t> vertex;      // #N to one of its vertices
    std::vector<bool> fixed;                // #N: it stays, as do ends and junctions of rails
    std::vector<bool> shared;  // #N: its point is of other fans, or triangles left out, too
    std::vector<bool> hard;    // #N: its vertices' normals differ beyond a smooth bend
    std::vector<bool> faceted; // #T: it is shaded flat
    std::vector<Rail> rails;
    std::vector<Mesh::Crease> kept_creases; // at fixed points and between triangles left out
    // Triangles that repeat a point, or have an edge with more than two or two that disagree in
    // their direction: no half-edge mesh holds those. Their points stay.
    std::size_t left_out = 0;
};

// O(#C log valence).
Fans fans_of(const Mesh& mesh);

} // namespace trivar

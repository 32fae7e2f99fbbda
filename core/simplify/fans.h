// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Fans are a mesh as decimation wants it: nodes, and triangles whose edges have one or two
// triangles. A node is a fan of triangles round a point of the surface; a point in which several
// fans touch has several nodes.
struct Fans {
    static constexpr std::uint32_t none = ~0u;
    // A Rail is an edge of a line that must stay a line: a border, a crease, or where both sides
    // differ in material, group, texture coordinates, colours, influences or the direction of their
    // normals.
    struct Rail {
        std::uint32_t a, b; // nodes
        float sharpness;    // of the crease, 0: none
    };
    // #V: the vertex that stands for all of a point with equal values
    std::vector<std::uint32_t> first_equal;
    std::vector<glm::uvec3> triangles; // #T to such vertices
    std::vector<std::uint32_t> face;   // #T to the face of which it is a piece
    std::vector<glm::uvec3> nodes;     // #T; `none` for a triangle that is left out
    std::vector<std::uint32_t> vertex; // #N to one of its vertices
    std::vector<bool> fixed;           // #N: the node stays, as do ends and junctions of rails
    std::vector<bool> shared;  // #N: its point also belongs to other fans, or to triangles left out
    std::vector<bool> hard;    // #N: its vertices' normals differ beyond a smooth bend
    std::vector<bool> faceted; // #T: it is shaded flat
    std::vector<Rail> rails;
    std::vector<Mesh::Crease> kept_creases; // at fixed points and between triangles left out
    // The number of triangles that are left out because no half-edge mesh can hold them: they
    // repeat a point, or have an edge with more than two triangles, or with two that disagree in
    // direction. Their points stay.
    std::size_t left_out = 0;
};

// O(#C log valence).
Fans fans_of(const Mesh& mesh);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/split/split_error.h"

namespace trivar {

// VertexPlaces classifies the vertices of a mesh: beyond which sides of the field's reach they are,
// one bit each, and on which side of every cut surface; the sides of the first two surfaces are
// bits too.
struct VertexPlaces {
    static constexpr int beyond_any = 0x3f, first_above = 6, surfaces_in_bits = 2;
    std::vector<std::uint8_t> bits;  // #V
    std::vector<std::uint8_t> above; // #V x (#openings - 2)
    struct Block {                   // of vertices_per_block vertices
        Box box;                     // in uvw
        std::uint32_t least_point = 0xffffffff, greatest_point = 0;
    };
    static constexpr std::size_t vertices_per_block = 2048;
    std::vector<Block> blocks;
    Box box;                // in uvw
    std::size_t points = 0; // of the mesh
};

// O(#V) in parallel; the memory of `out` is used again.
void find_places(const Mesh& mesh, const SplitField& field, VertexPlaces& out);

// ToChange lists the part of a mesh that is to be changed.
struct ToChange {
    std::vector<std::uint32_t> faces; // ascending
    std::vector<char> free; // by point: where all faces are among these, so that edges may be split
    bool moves = false;     // whether any face is in reach
    double off = 0;         // metres: bound for the faces in reach that stay as they are
};

// Finds the faces that may be too coarse and those that are cut, with all faces that share a point
// with a coarse one, since its edges may be split. `tolerance` in metres. O(#C) in parallel; the
// memory of `out` is used again.
void find_changes(const Mesh& mesh, const VertexPlaces& places, const SplitField& field,
                  const SplitError& error, double tolerance, ToChange& out);

} // namespace trivar

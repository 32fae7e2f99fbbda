// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/lattice_signs.h"

#include <array>
#include <bit>

namespace trivar {

// The number of bits: a call of a library where the processor is not told to have one for it.
inline std::uint32_t number_of_bits(std::uint64_t of)
{
    of -= of >> 1 & 0x5555555555555555;
    of = (of & 0x3333333333333333) + (of >> 2 & 0x3333333333333333);
    of = (of + (of >> 4)) & 0x0F0F0F0F0F0F0F0F;
    return static_cast<std::uint32_t>(of * 0x0101010101010101 >> 56);
}

// A LevelBrick is 8 x 8 x 8 samples round which a level passes, with the lattice edges that it
// crosses and that begin there. Edges are numbered without a table: those of a row by the bits of
// one word.
struct LevelBrick {
    glm::ivec3 at; // brick, along each axis
    // Crossed edges by row y + 8 z: bit x + 8 d is the edge from sample x in the direction d = 1 ..
    // 7, whose bits are its steps along x, y and z.
    std::array<std::uint64_t, 64> crossing{};
    std::array<std::uint16_t, 64> before{}; // number of edges in the rows before
    std::uint32_t first_vertex = 0, vertices = 0, first_triangle = 0, triangles = 0;

    // The number of an edge from a sample of this brick, 0 .. 7 along each axis, among its own.
    std::uint32_t edge(const glm::ivec3& sample, int direction) const
    {
        const auto row = static_cast<std::size_t>(sample.y + 8 * sample.z);
        const std::uint64_t earlier = (std::uint64_t{1} << (8 * direction + sample.x)) - 1;
        return before[row] + number_of_bits(crossing[row] & earlier);
    }
    std::uint32_t vertex(const glm::ivec3& sample, int direction) const
    {
        return first_vertex + edge(sample, direction);
    }
};

// The bricks that a level passes, by z, y and x, with the number of each in the grid of bricks.
struct LevelBricks {
    std::vector<LevelBrick> all;
    std::vector<std::int32_t> number; // by brick, x fastest; -1: none
    glm::ivec3 count;                 // bricks along each axis
    std::uint32_t vertices = 0, triangles = 0;

    const LevelBrick* at(const glm::ivec3& brick) const // null: none
    {
        if (glm::any(glm::greaterThanEqual(brick, count))) return nullptr;
        const std::int32_t n = number[index(brick)];
        return n < 0 ? nullptr : &all[static_cast<std::size_t>(n)];
    }
    std::size_t index(const glm::ivec3& b) const
    {
        return static_cast<std::size_t>(b.x) +
               static_cast<std::size_t>(count.x) *
                   (static_cast<std::size_t>(b.y) +
                    static_cast<std::size_t>(count.y) * static_cast<std::size_t>(b.z));
    }
};
LevelBricks level_bricks(const LatticeSigns& signs);

// Calls use(x, inside) for every cell of a row of a brick that the level crosses, with the bits of
// its corners.
void for_cells(const LatticeSigns& signs, const glm::ivec3& brick, int y, int z, auto&& use)
{
    const int row = 8 * brick.y + y, layer = 8 * brick.z + z;
    if (row + 1 >= signs.size().y || layer + 1 >= signs.size().z) return;
    const unsigned a = signs.row(row, layer, brick.x), b = signs.row(row + 1, layer, brick.x),
                   c = signs.row(row, layer + 1, brick.x),
                   d = signs.row(row + 1, layer + 1, brick.x);
    unsigned any = a | b | c | d, all = a & b & c & d;
    any |= any >> 1;
    all &= all >> 1;
    for (unsigned left = any & ~all & (signs.mask(brick.x) >> 1) & 0xFF; left; left &= left - 1) {
        const int x = std::countr_zero(left);
        use(x, static_cast<std::uint8_t>((a >> x & 3) | (b >> x & 3) << 2 | (c >> x & 3) << 4 |
                                         (d >> x & 3) << 6));
    }
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace trivar {

// A KuhnEdge leads from a corner of a cell to a greater one, whose bits are more:
//
//        6-------7      corner c is at (c & 1, c >> 1 & 1, c >> 2)
//       /|      /|
//      4-------5 |      2--o------3      the face z = 0 with only corner 2 inside: o are
//      | 2-----|-3      | /     . |      vertices on its edges 0-2 and 2-3; the diagonal
//      |/      |/       o/   .    |      0-3 of the face (dots) is not crossed
//      0-------1        | .       |
//                       0---------1
struct KuhnEdge {
    std::uint8_t corner;    // 0 .. 7
    std::uint8_t direction; // 1 .. 7, the bits of the other corner that this one lacks
};

// Returns the triangles of a cell, at most 12, three edges each. The cell is the six tetrahedra
// that share its diagonal 0-7 [Freudenthal 1942; Kuhn 1960], each with one or two triangles between
// its edges that change sides. Triangles run counter-clockwise as seen from outside, and equal
// faces of neighbouring cells are cut alike. `inside`: bit c is set if corner c is inside.
std::span<const std::array<KuhnEdge, 3>> kuhn_triangles(std::uint8_t inside);

} // namespace trivar

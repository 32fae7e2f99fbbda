// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace trivar {

// A KuhnEdge leads from a corner of a cell to a greater one, whose bits are more: corner c is at
// (c & 1, c >> 1 & 1, c >> 2).
struct KuhnEdge {
    std::uint8_t corner;    // 0 .. 7
    std::uint8_t direction; // 1 .. 7, the bits of the other corner that this one lacks
};

// The triangles of a cell whose corners are inside (bit 1) or outside: the cell is the six
// tetrahedra that share its diagonal [Freudenthal 1942; Kuhn 1960], each with one or two triangles
// between its edges that change sides. Three edges a triangle, at most 12 triangles; seen from
// outside they run counter-clockwise. Equal faces of neighbouring cells are cut alike.
std::span<const std::array<KuhnEdge, 3>> kuhn_triangles(std::uint8_t inside);

} // namespace trivar

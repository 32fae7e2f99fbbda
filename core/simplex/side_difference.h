// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace trivar {

// A SidePlace is a corner of a triangle, or a root on an edge, where a body's border crosses it; it
// lies between points a and b of a lattice.
struct SidePlace {
    bool is_root = false;
    std::uint32_t id = 0;
    std::size_t a = 0, b = 0;
    bool operator==(const SidePlace& other) const
    {
        return is_root == other.is_root && id == other.id;
    }
};

// A TriangleSide is the part of a triangle that is in the body on one side of it.
struct TriangleSide {
    std::array<bool, 3> in{};
    std::array<SidePlace, 3> corners;
    std::array<SidePlace, 3> roots; // on the edges from corner i to the next, where `in` changes
};

// The piece of edge i that is in the body; from == to: nothing of it.
struct SidePiece {
    SidePlace from, to;
    bool empty() const { return from == to; }
};
SidePiece piece(const TriangleSide& side, std::size_t i);

// Returns the polygons of (here minus there), oriented like the triangle, and of (there minus
// here), reversed. Their points on an edge follow from that edge alone, so that triangles which
// share it fit, whatever crosses inside; a polygon may fold for that.
std::vector<std::vector<SidePlace>> side_difference(const TriangleSide& here,
                                                    const TriangleSide& there);

} // namespace trivar

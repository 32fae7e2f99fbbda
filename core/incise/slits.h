// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/fill.h"
#include "core/incise/runs.h"

namespace trivar {

// Depths of walls are whole numbers: this many to the greatest depth that was asked for.
inline constexpr int depth_steps = 1 << 16;

// A SlitEdge is an edge along which the skin is cut, from point a to point b, a < b. Several runs
// may pass it.
struct SlitEdge {
    struct Pass {
        std::uint32_t piece;
        double s_a, s_b;
        bool forward; // from a to b
    };
    std::uint32_t a, b;
    std::vector<Pass> passes; // at most one of each piece
    bool flat_floor = false;  // U
    bool through = false;     // its walls go on from their last rows to the far side
    bool far_side = false;    // an edge of the far side of a cut: without rows
    int depth_a = 0, depth_b = 0;
    int bevel_a = 0, bevel_b = 0; // depths of the bevel, 0: none
    bool rounded = false;         // the bevel

    bool has_floor() const { return !through && !far_side; }

    bool starts_at(std::uint32_t point) const { return a == point; }
    int depth_at(std::uint32_t point) const { return a == point ? depth_a : depth_b; }
};

// A SlitNode is a point at which slit edges end. They divide the skin round it into sectors: sector
// i lies between edge i and the next one, counter-clockwise. Below the node hangs a column of
// levels; at each level sectors that belong together are one vertex.
//
//            e1              level 0, the skin  s0   s1   s2     three vertices
//        s1  |  s0           level 1            s0   s1   s2
//            |               level 2            s0 = s1   s2     below the floor of e1
//      e2 ---+--- e0         level 3            s0 = s1 = s2     the deepest floor: that of
//            s2                                                  e0 and e2
struct SlitNode {
    std::uint32_t point = 0;
    std::vector<std::uint32_t> edges;   // counter-clockwise
    std::vector<int> levels;            // ascending from 0
    std::vector<std::uint32_t> corners; // #levels by #edges: the vertex of a sector at a level

    std::uint32_t corner(std::size_t level, std::size_t sector) const
    {
        return corners[level * edges.size() + sector];
    }
    std::size_t edge_number(std::uint32_t edge) const; // 0 .. #edges - 1
    std::size_t level_number(int depth) const;
};

struct SlitGraph {
    std::vector<SlitEdge> edges;
    std::vector<SlitNode> nodes;
    KeyNumbers node_of_point;
};

// Makes the slit edges of runs with depths, and their nodes, whose edges are in no order yet. No
// floor hangs free: the deepest floor of a node belongs to two edges at least, or lies above the
// last row of a cut through the body. Edges without depth are left out.
//   step   the depth of one of depth_steps, units of the mesh
//   alike  floors nearer than so many steps become one
SlitGraph slits_of(const std::vector<SlitRun>& runs, const std::vector<SlitPiece>& pieces,
                   std::span<const Incision> incisions, const SlitDrawing& drawing,
                   const Inward& inward, double step, int alike);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slits.h"
#include "core/incise/through.h"

namespace trivar {

// A SlitPatch is the skin round the cuts, in pieces between points of the drawing.
struct SlitPatch {
    std::vector<SkinTriangle> triangles;
    std::vector<std::uint32_t> replaced; // triangles of the skin, ascending; of whole faces
    KeyNumbers triangle_of_side;         // a piece by its directed edge
    // The sector of the node at each corner of each piece, or none.
    std::vector<std::array<std::uint32_t, 3>> sectors;

    bool replaces(std::uint32_t triangle) const;
};

// A WallCorner is a corner of a wall: a vertex of a column, and the sector and the edge for which
// it stands there.
struct WallCorner {
    std::uint32_t vertex, node, sector, edge;
};
struct WallTriangle {
    std::array<WallCorner, 3> corners; // counter-clockwise as seen from the gap
    int level;                         // depth of its upper end
    bool floor = false;
};

// SlitVertex: a vertex that cutting makes at a point of the drawing, at a depth in steps.
struct SlitVertex {
    std::uint32_t node;
    int depth;
};

// SlitWalls are the result of cutting: closed and manifold where the skin was, whatever the graph
// is, and of the same Euler number. No coordinate enters: sides are told by going round a node, and
// every edge of a wall is counted. Vertices from the drawing's number of points on are `made`.
struct SlitWalls {
    std::vector<std::array<std::uint32_t, 3>> skin; // vertices, by piece of the patch
    std::vector<WallTriangle> walls;
    std::vector<SlitVertex> made;
};

// The patch of a drawing and of the nodes of a graph, whose edges it puts in order.
SlitPatch patch_of(const SlitDrawing& drawing, std::vector<SkinTriangle> pieces, SlitGraph& graph);

// `rows` levels below a node at least; `borders`: depths between layers, ascending, in steps.
SlitWalls walls_of(const SlitDrawing& drawing, const SlitPatch& patch, SlitGraph& graph, int rows,
                   std::span<const int> borders, const std::vector<SlitRun>& runs,
                   const std::vector<ThroughSlit>& throughs);

} // namespace trivar

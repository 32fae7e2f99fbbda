// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/field.h"

namespace trivar {

// A LeftOut marks the parts of a shape that belong to pieces that are left out: nothing, or a mark
// for each triangle of the patch and of the walls, and triangles of the skin beside the patch.
struct LeftOut {
    std::vector<char> patch, walls;
    std::vector<std::uint32_t> skin; // ascending

    bool none() const { return patch.empty(); }
    bool patch_piece(std::size_t t) const { return !none() && patch[t]; }
    bool wall(std::size_t w) const { return !none() && walls[w]; }
};

// A SlitShape is the state of all cuts in a skin after the passes of incise().
struct SlitShape {
    const SlitDrawing& drawing;
    std::size_t point_count; // of the drawing, when this was made: it may have got more since
    const Inward& inward;
    const SlitColumns& columns;
    double step; // depth of one of depth_steps
    std::vector<SlitRun> runs;
    std::vector<SlitPiece> pieces;
    SlitGraph graph;
    SlitPatch patch;
    SlitWalls walls;
    std::vector<SlitTerm> terms;
    LeftOut left_out = {};

    // Numbers of vertices: those of the drawing's points, then those that cutting made.
    std::size_t vertex_count() const { return point_count + walls.made.size(); }
    std::uint32_t base_point(std::uint32_t vertex) const; // of the drawing, below which it hangs
    double depth(std::uint32_t vertex) const;             // units of the mesh
    glm::dvec3 rest_position(std::uint32_t vertex) const;
};

inline std::uint32_t SlitShape::base_point(std::uint32_t vertex) const
{
    const std::size_t first = point_count;
    return vertex < first ? vertex : graph.nodes[walls.made[vertex - first].node].point;
}

inline double SlitShape::depth(std::uint32_t vertex) const
{
    const std::size_t first = point_count;
    return vertex < first ? 0 : walls.made[vertex - first].depth * step;
}

inline glm::dvec3 SlitShape::rest_position(std::uint32_t vertex) const
{
    const std::uint32_t base = base_point(vertex);
    const double below = depth(vertex);
    const glm::dvec3 p = drawing.position(base);
    return below > 0 ? p - below * columns.outward(base) : p;
}

} // namespace trivar

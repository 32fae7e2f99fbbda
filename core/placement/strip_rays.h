// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/judgement.h"
#include "core/rays/ray_scene.h"

#include <vector>

namespace trivar {

// A StripCut is a strip cut into quads, with the same even number of quads per cell of control
// points along each axis. Marks on it are one per corner of the quads, v fastest.
struct StripCut {
    glm::ivec2 cells;
    int quads_a_cell;

    glm::ivec2 quads() const { return quads_a_cell * cells; }
    std::size_t corners() const
    {
        return static_cast<std::size_t>((quads().x + 1) * (quads().y + 1));
    }
    std::size_t corner(int i, int j) const
    {
        return static_cast<std::size_t>(i * (quads().y + 1) + j);
    }
    std::size_t middle_of_cell(int i, int j) const
    {
        return corner(quads_a_cell * i + quads_a_cell / 2, quads_a_cell * j + quads_a_cell / 2);
    }
};

// Marks the changed cells in or beside which the cosine between the surface and the line of sight
// falls below the limit.
std::vector<char> steep_corners(const SurfaceTable& s, const StripCut& cut,
                                const std::vector<char>& changed, const View& view, double limit);

// A RayLook says how densely rays look at the surface: one ray per cell, and many along each axis
// of a cell at the rim and where the surface is seen edge-on, for there the picture hardly tells
// where on the surface a point of the scene belongs.
struct RayLook {
    int where_steep = 1;
    // each turn looks at other places in the cells: a second look at the same place finds nothing
    // new
    int turn = 0;
    // false: looks only in front of the surface; true: also behind it
    bool beyond = false;
    bool skip_back_faces = false;
};

struct SeenBehind {
    Judgement found;
    double largest_gap = 0; // metres between surface and scene; only with `beyond`
};

// The points that the camera sees in front of the surface, in cells whose middle is marked.
// Parallel.
SeenBehind seen_behind(const SurfaceTable& s, const StripCut& cut, const std::vector<char>& marked,
                       const RayLook& look, const View& view, const RayScene& scene,
                       const JudgeOptions& options);

} // namespace trivar

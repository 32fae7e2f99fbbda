// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/judgement.h"
#include "core/placement/ray_scene.h"

#include <vector>

namespace trivar {

// A strip cut into quads: so many a cell of control points along each axis, an even number. Marks
// on it are one a corner of the quads, v fastest.
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

// Marks the cells in or beside which the cosine between the surface and the line of sight falls
// below the limit, among what has changed.
std::vector<char> steep_corners(const SurfaceTable& s, const StripCut& cut,
                                const std::vector<char>& changed, const View& view, double limit);

// How to look along rays: one a cell, and many along each axis of it at the rim and where the
// surface is seen edge-on, for there the picture hardly tells where on the surface a point of the
// scene belongs.
struct RayLook {
    int where_steep = 1;
    int turn = 0;        // each elsewhere in the cells: a second one there would find nothing
    bool beyond = false; // looks for what is in front of the surface alone, or behind it, too
    bool skip_back_faces = false;
};

struct SeenBehind {
    Judgement found;
    double largest_gap = 0; // metres between surface and scene; where asked to look beyond
};

// What the camera sees behind the surface, of cells whose middle is marked. Parallel.
SeenBehind seen_behind(const SurfaceTable& s, const StripCut& cut, const std::vector<char>& marked,
                       const RayLook& look, const View& view, const RayScene& scene,
                       const JudgeOptions& options);

} // namespace trivar

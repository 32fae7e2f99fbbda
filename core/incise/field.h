// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/walls.h"

namespace trivar {

// A SlitTerm is the move of a vertex by one fully open incision; the terms of a vertex add up.
struct SlitTerm {
    std::uint32_t vertex; // of the drawing, or made by cutting
    std::uint32_t incision;
    float share;    // of the incision's length, at which the vertex stands
    float below;    // depth of the vertex, as a share of the floor's there; 1 at most
    glm::vec3 move; // units of the mesh
    float held = 1; // what is left of it beside other incisions
};

// Computes the field of each incision: continuous everywhere but across its own slit. Beside the
// cut the skin moves to that side, across the cut; less with the distance from it, with the depth
// below the skin and towards the ends. Sides at the slit come from the sectors, and elsewhere from
// a flood that starts there.
//   pieces   of the runs; worked on in parallel
//   step     depth of one of depth_steps, units of the mesh
// The same terms for any number of threads.
std::vector<SlitTerm> field_of(const SlitDrawing& drawing, const SlitPatch& patch,
                               const SlitGraph& graph, const SlitWalls& walls,
                               const std::vector<SlitRun>& runs,
                               const std::vector<SlitPiece>& pieces,
                               std::span<const Incision> incisions, const Inward& inward,
                               double step);

} // namespace trivar

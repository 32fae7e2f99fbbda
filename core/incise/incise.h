// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_skin.h"
#include "core/incise/incision.h"

#include <string>

namespace trivar {

struct InciseOptions {
    int rows = 4; // of wall triangles from the skin down to the deepest floor
    std::vector<WallLayer> layers =
        {};              // from the skin down; none: walls look as the skin above them
    bool guarded = true; // depths and openings stay such that no wall meets another
    double reach = 0.01; // of the skin's diagonal: strokes are looked for so far off the skin
};

// IncisedMesh: a mesh with all that cutting adds to it. Its topology depends on the strokes, depths
// and floors alone; a change of an opening is one pass over the terms.
struct IncisedMesh {
    // What became of an incision.
    struct Outcome {
        std::string refusal; // why there is no cut, a sentence; empty: there is one
        double length = 0, depth = 0;
        double widest = 0; // share of the width that the guard admits
    };
    struct Term {
        std::uint32_t slot, incision;
        float share;    // of the incision's length
        glm::vec3 move; // when quite open, before the guard
    };
    Ref<Mesh> original,
        rest; // rest: shut, with walls; the same as the original where nothing is cut
    std::vector<Outcome> outcomes; // by incision
    std::vector<Term> terms;
    std::size_t slots = 0;
    // The vertices of `rest` that move, and the slot of each: copies of a point move as one.
    std::vector<std::uint32_t> moved, slot_of_moved;
    std::uint32_t first_wall_vertex = 0, first_wall_face = 0; // in `rest`, where walls come last
};

// Cuts a skin. An incision that cannot be cut is left out, and its outcome says why. Closed stays
// closed and 2-manifold, with the Euler number that it had; seams stay and none is made; vertices
// of the mesh keep their numbers and bits. Costs what the region of the cuts costs, and one copy of
// the arrays. The same bits for any number of threads.
//   Base: the room's page docs/incise.md tells the steps.
IncisedMesh incise(const CutSkin& skin, std::span<const Incision> incisions,
                   const InciseOptions& options = {});

// Where the vertices that move are at some openings, one for each incision, and the normals of the
// walls. O(#terms + #walls), whatever the size of the mesh.
struct OpenedVertices {
    std::vector<glm::vec3> positions;    // by IncisedMesh::moved
    std::vector<glm::vec3> wall_normals; // from first_wall_vertex on
};
OpenedVertices opened_vertices(const IncisedMesh& incised,
                               std::span<const IncisionOpening> openings);

// The whole mesh at some openings; the original itself while all are shut.
Ref<Mesh> opened(const IncisedMesh& incised, std::span<const IncisionOpening> openings);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/incise/incision.h"
#include "core/mesh/mesh.h"

#include <span>
#include <string>

namespace trivar {

// An IncisedMesh is a mesh with all that cutting adds to it. Nothing of it depends on openings: a
// change of these is one pass over the terms.
struct IncisedMesh {
    // The Outcome of cutting one incision.
    struct Outcome {
        std::string refusal;          // why there is no cut, a sentence; empty: there is one
        std::string shortfall;        // why it has a floor where it was to go through, or keeps its
                                      // piece, a sentence; empty: it is as it was to be
        std::string notice;           // a sentence where only a part of the stroke is cut
        double length = 0, depth = 0; // units of the mesh; the depth after all limits
        // The guard's result: the widest opening, as a share of the widest that was asked for; the
        // least share anywhere along the incision; and the least further share to which the part
        // below the skin is drawn together.
        double widest = 0, least = 0, least_below = 0;
        // The widest opening while those are shut that hold it: incisions before it.
        double widest_alone = 0;
        std::vector<std::uint32_t> held_by = {};
        // The least share of the depth that was asked for, but near its ends, that there is room
        // for along the incision; of a cut through the body 1.
        double least_depth = 1;
        int crossed_through = 0; // how often it crosses cuts that go through as it does
    };
    struct Term {
        std::uint32_t slot, incision;
        float share;    // of the incision's length
        float held;     // what is left of the move beside those that hold the incision
        glm::vec3 move; // units of the mesh, when quite open; the guard has narrowed it
    };
    Ref<Mesh> original;
    Ref<Mesh> rest; // shut, with walls; the same as the original where nothing is cut
    std::vector<Outcome> outcomes; // by incision
    std::vector<Term> terms;
    std::size_t slots = 0;
    bool has_hole = false; // a piece is left out, however shut all cuts are
    // The vertices of `rest` that move, and the slot of each: copies of a point move as one.
    std::vector<std::uint32_t> moved, slot_of_moved;
    std::uint32_t first_wall_vertex = 0, first_wall_face = 0; // in `rest`, where walls come last
    std::vector<glm::vec3>
        wall_tops; // of each vertex of a wall: where its column begins on the skin
};

// Returns how far the incisions that hold one are open: 0, all are shut, to 1.
double held_open(const IncisedMesh& incised, std::uint32_t incision,
                 std::span<const IncisionOpening> openings);

// Positions of the moving vertices at some openings, one for each incision, and normals of the
// walls. `more`: further moves by slot; empty: none. O(#terms + #walls), whatever the size of the
// mesh.
struct OpenedVertices {
    std::vector<glm::vec3> positions;    // by IncisedMesh::moved
    std::vector<glm::vec3> wall_normals; // from first_wall_vertex on
};
OpenedVertices opened_vertices(const IncisedMesh& incised,
                               std::span<const IncisionOpening> openings,
                               std::vector<glm::dvec3> more = {});

// Whether any incision is open at all, or a piece is left out.
bool is_open(const IncisedMesh& incised, std::span<const IncisionOpening> openings);
// Moves the vertices of a copy of `rest`, at whatever openings it is.
void put(const IncisedMesh& incised, const OpenedVertices& vertices, Mesh& copy);

// The whole mesh at some openings; the original itself while all are shut and no piece is left out.
Ref<Mesh> opened(const IncisedMesh& incised, std::span<const IncisionOpening> openings);

} // namespace trivar

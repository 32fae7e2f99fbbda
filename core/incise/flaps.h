// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/flap_place.h"
#include "core/incise/incised.h"

namespace trivar {

// IncisedFlaps bend flaps of an incised mesh outward. A flap moves with the product of the effects
// of both its incisions on a point, so it stays whole: zero at its base, at the ends of both, and
// across either of them. Its tip is raised by its lift, and turns back as if hinged at its base.
struct IncisedFlaps {
    struct Lifted {
        std::uint32_t slot, flap;
        float weight;               // 1 at the tip, while both are quite open
        glm::vec3 up;               // unit
        std::uint32_t incisions[2]; // numbers of both
        float shares[2];            // of their lengths
    };
    std::vector<Lifted> lifted;
    std::vector<double> lengths;  // by flap: from its tip to its base; 0: there is no such flap
    std::vector<glm::vec3> backs; // by flap: from the tip to the base, unit

    // The vertices of the skin on flaps, whose normals turn with it, and the triangles round them.
    std::vector<std::uint32_t> skin;
    struct SkinCorner {
        std::uint32_t vertex, moved, skin; // of `rest`; in IncisedMesh::moved; in `skin`; or none
    };
    std::vector<SkinCorner> corners;          // three a triangle
    std::vector<std::uint32_t> group_of_skin; // copies of a point on one side turn as one
    std::vector<glm::dvec3> group_normals;    // at rest, by area
};

// Makes the flaps of an incised mesh.
//   incisions  those from which the mesh was made
//   places     of the flaps
// O(#flaps #slots + #faces).
IncisedFlaps flaps_of(const IncisedMesh& incised, std::span<const Incision> incisions,
                      std::span<const FlapPlace> places);

// Returns how far flaps move each slot. `lifts`: units of the mesh, by flap.
std::vector<glm::dvec3> lifted_moves(const IncisedMesh& incised, const IncisedFlaps& flaps,
                                     std::span<const double> lifts,
                                     std::span<const IncisionOpening> openings);
// The normals of the skin on flaps where the vertices that move are at `positions`.
std::vector<glm::vec3> turned_normals(const IncisedMesh& incised, const IncisedFlaps& flaps,
                                      std::span<const double> lifts,
                                      std::span<const glm::vec3> positions);

} // namespace trivar

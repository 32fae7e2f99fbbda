// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_closing.h"
#include "core/split/split_reach.h"

#include <optional>

namespace trivar {

struct SplitOptions {
    // Metres: no triangle of the result is further from where the field takes it, as long as there
    // are at most that number of triangles.
    double tolerance = 1e-3;
    std::size_t most_triangles = 4000000;
    SplitClosing closing = SplitClosing::capped;
    bool keep_rest = false;     // rest_positions are wanted
    std::uint32_t material = 0; // face_material of the caps
};

// A SplitMesh is a mesh that was parted by the openings of a field.
struct SplitMesh {
    Mesh mesh;                             // cut, closed and moved by the field
    std::vector<glm::vec3> rest_positions; // #V, before they were moved; empty: not wanted
    // The first face of those of caps and of triangles that were cut; all later ones are such.
    std::size_t first_new_face = 0;
    std::size_t fans = 0;           // see Caps
    std::size_t open = 0, gaps = 0; // see Caps
    double off = 0; // metres: bound of the distance of its triangles from the true surface
};

// Parts a mesh in the world: makes it fine enough near the openings, cuts it along each cut
// surface, closes both halves with caps, and moves its vertices by the field. A closed mesh becomes
// closed parts; none of its vertices lies in an obstacle. Stitched, its skin is drawn in beside the
// openings (see Seam) and stays one beyond them (see sew()). Vertices that the field does not move
// keep their bits. Faces that are fine enough and not cut are only moved: they keep their order and
// stand first, but for some beside others. Nothing: the field moves no part of the mesh. O(#V + #C)
// to find the others, and the work of these.
std::optional<SplitMesh> split(const Mesh& mesh, const SplitField& field,
                               const SplitOptions& options);

// A SplitMemory is memory that a frame takes over from the one before; its values do not count.
struct SplitMemory {
    Mesh mesh; // give it one that is not needed any more, best a result of a frame
    VertexPlaces places;
    ToChange change;
};

// The same, while frames go on: with the memory of earlier frames.
std::optional<SplitMesh> split(const Mesh& mesh, const SplitField& field,
                               const SplitOptions& options, SplitMemory& memory);

} // namespace trivar

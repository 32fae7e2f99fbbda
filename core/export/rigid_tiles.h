// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/patches/tile_fit.h"

namespace trivar {

// A RigidCount counts how the tiles of a layer are stored in a file with instances.
struct RigidCount {
    std::string name;          // of the layer
    std::size_t meshes = 1;    // whose tiles are counted, each for itself
    std::size_t instances = 0; // tiles that a translation, a rotation and scales place
    std::size_t sheared = 0;   // tiles that only a matrix places
    std::size_t bent = 0;      // tiles that neither places within the tolerance: they stay bent
    double off = 0;            // the furthest that a vertex of the others is from its place, metres
    double off_bent = 0;       // the same of those that stay bent, if they did not
};
// One sentence per layer.
std::vector<std::string> sentences(const std::vector<RigidCount>& counts, double tolerance);

// A RigidTile is how one tile of a layer is best written without its bend, all of its meshes in the
// same way.
struct RigidTile {
    enum class Way { instance, sheared, bent } way = Way::bent;
    // The furthest that a vertex is from its place, metres: this way, or as an instance where it
    // stays bent; infinite if it mirrors.
    double off = 0, off_instance = 0;
    std::vector<NodeTransform> parts; // by mesh, as an instance; empty: it mirrors
    std::vector<glm::dmat4> matrices; // by mesh, this way; empty where it stays bent
};
// Rounds the parts of a transform as a file stores them, in double precision again.
using StoredParts = NodeTransform (*)(const NodeTransform&);
NodeTransform in_single_precision(const NodeTransform& parts);

// `parts` are those of a layer with the same tiles. In parallel, in double precision; the same on
// any machine. O(#tiles #V).
std::vector<RigidTile> rigid_tiles(const std::vector<const Part*>& parts, double tolerance,
                                   StoredParts stored);

// The parts of a layer in groups with the same tiles, by their numbers; without those that are no
// tiles or that a volume bends.
std::vector<std::vector<std::size_t>> parts_of_tiles(const std::vector<Part>& parts);

// A RigidScene is a scene in which tiles within the tolerance are parts of their own with the mesh
// of one tile, behind the other parts of their layer. The tiles of a part that stay bent remain as
// a mesh, which may be empty.
struct RigidScene {
    Evaluation evaluated;
    std::vector<RigidCount> counts;
};
RigidScene with_rigid_tiles(const Evaluation& evaluated, const Document& document,
                            double tolerance);

} // namespace trivar

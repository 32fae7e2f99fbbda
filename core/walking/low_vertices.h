// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/pose.h"

namespace trivar {

// A ModelVertex is a vertex of the mesh that hangs on a node.
struct ModelVertex {
    int node = 0;
    std::uint32_t vertex = 0;
};

// The joint or node with the greatest influence on the vertex.
int mover_of(const Model& model, const ModelVertex& vertex);

// A VertexMover is one influence on a vertex: a matrix times `before`, and its weight.
struct VertexMover {
    int node = 0;
    glm::dmat4 before{1};
    double weight = 1;
};
std::vector<VertexMover> movers_of(const Model& model, const ModelVertex& vertex);

// The position of a vertex in a model in that stance, with that pose of its mesh.
glm::dvec3 position_of(const Model& model, const ModelVertex& vertex, const Stance& stance,
                       const Pose& pose);
// The positions of several vertices; each mesh is posed once.
std::vector<glm::dvec3> positions_of(const Model& model, const std::vector<ModelVertex>& vertices,
                                     const Stance& stance);

struct LowVertices {
    std::vector<ModelVertex> vertices; // the lowest first
    double ground = 0;                 // height of the lowest vertex of all, at least the floor
};

// The vertices that come within `within` of the ground in one of these stances. Where there are
// more than `most`, an even selection of them. Any number of threads gives the same bits.
// O(#stances #V).
LowVertices low_vertices(const Model& model, const std::vector<Stance>& stances,
                         const glm::dvec3& up, double within, double floor, std::size_t most);

} // namespace trivar

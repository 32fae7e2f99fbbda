// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/pose.h"

namespace trivar {

// A vertex of the mesh that hangs on a node.
struct ModelVertex {
    int node = 0;
    std::uint32_t vertex = 0;
};

// The joint or node that moves it most.
int mover_of(const Model& model, const ModelVertex& vertex);

// What moves a vertex: each by its matrix times `before`, and so much of it.
struct VertexMover {
    int node = 0;
    glm::dmat4 before{1};
    double weight = 1;
};
std::vector<VertexMover> movers_of(const Model& model, const ModelVertex& vertex);

// Where it is in a model that stands so, with that pose of its mesh.
glm::dvec3 position_of(const Model& model, const ModelVertex& vertex, const Stance& stance,
                       const Pose& pose);
// Where several are; each mesh is posed once.
std::vector<glm::dvec3> positions_of(const Model& model, const std::vector<ModelVertex>& vertices,
                                     const Stance& stance);

struct LowVertices {
    std::vector<ModelVertex> vertices; // the lowest first
    double ground = 0;                 // height of the lowest of all, no less than the floor
};

// The vertices that come less than `within` over the ground while a model stands in these ways.
// Where they are more than `most`, evenly some of them. Bit for bit the same for any number of
// threads. O(#stances #V).
LowVertices low_vertices(const Model& model, const std::vector<Stance>& stances,
                         const glm::dvec3& up, double within, double floor, std::size_t most);

} // namespace trivar

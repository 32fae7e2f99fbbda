// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/surface_shape.h"
#include "core/mesh/mesh.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// A MeshShape is a mesh as lines see it: its smooth patches, and the sharp edges at which they end.
struct MeshShape {
    // A sharp edge joins two points, or is a border, with a face on one side only.
    struct Edge {
        std::uint32_t a, b;      // points
        glm::vec3 first, second; // unit normals of its faces; of a border both the same
        bool border;
    };
    SurfaceShape surface; // vertices of different patches at one point are different ones
    std::vector<glm::vec3> points;
    std::vector<Edge> edges;
    bool closed = false; // without borders: nothing is seen from inside
};

// Finds the patches of a mesh: faces at an edge belong to one unless their normals differ by more
// than an angle or other than two faces meet there. Points are those of Mesh::points, else equal
// positions; of equal triangles one stays. The mesh's own normals are taken where they go with the
// faces round them, so that a deformed mesh has exact ones. `stretch` maps places before that.
// 0.3 us per triangle.
MeshShape mesh_shape(const Mesh& mesh, float crease_deg, const glm::mat3& stretch = glm::mat3(1));

// Finds the outlines of the smooth patches: zeros of <n, V>, n interpolated between vertices
// [Hertzmann, Zorin 2000]. Points are on edges; `bend` is above 0 where the surface is hollow along
// the sight. 10 ns per triangle.
Silhouettes outlines(const SurfaceShape& surface, const ViewPoint& view);

// Joins sharp edges to lines that end where other than two of them meet and at turns of more than
// 60 degrees. They are named by their edges.
Silhouettes edge_lines(std::span<const glm::vec3> points, std::span<const MeshShape::Edge> edges);

} // namespace trivar

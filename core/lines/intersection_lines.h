// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/mesh/mesh.h"
#include "core/silhouette/silhouettes.h"
#include "core/spline/box_tree.h"

namespace trivar {

// A TriangleBody is a surface as its intersections are found by: the triangles of meshes in one
// space, with a tree of their boxes. Vertices at one place of a mesh are one point.
struct TriangleBody {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    std::vector<Box> boxes; // of the triangles
    BoxTree tree;
};
// `to_space` maps a mesh into the space of the body. O(#C log #C), 1 us per triangle.
TriangleBody triangle_body(std::span<const std::pair<Ref<Mesh>, glm::dmat4>> meshes);

// Lines along which surfaces go through each other.
struct IntersectionLines {
    Silhouettes lines;                             // in the space of the bodies, less `origin`
    std::vector<std::array<glm::vec3, 2>> normals; // unit, of the triangles that meet, by point
    glm::dvec3 origin{0};                          // near the first body
};
// Finds where the surfaces of two bodies go through each other: the crossings of the edges of one
// with the triangles of the other, joined to connected lines that end at turns of more than 60
// degrees. Surfaces that only touch, as a box on a table does, do not go through each other. In
// double precision; a crossing has the same place and the same sides for all triangles at an edge.
// 2 us per triangle near the other body; the same for any number of threads.
IntersectionLines intersection_lines(const TriangleBody& a, const TriangleBody& b);
// The same of one body with itself: of triangles that have no point in common.
IntersectionLines intersection_lines(const TriangleBody& body);

} // namespace trivar

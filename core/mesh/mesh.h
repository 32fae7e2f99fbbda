// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace trivar {

// A Mesh is a polygon mesh as arrays. A vertex is what a GPU calls one: a position with one normal,
// one tangent, one colour and one texture coordinate per set. Where a seam gives a point of the
// surface two normals or two texture coordinates there are two vertices, and `points` says that
// they are one point. A deformation maps vertex by vertex: equal positions stay equal, bit for bit.
//
//   faces    f: corners[face_begin[f]] .. corners[face_begin[f + 1] - 1], counter-clockwise
//   corners  c: a vertex index                 vertices v: positions[v], normals[v], ...
struct Mesh {
    std::vector<glm::vec3> positions;         // #V
    std::vector<glm::vec3> normals;           // #V unit, or empty
    std::vector<glm::vec4> tangents;          // #V unit xyz, w = +1 or -1 (bitangent), or empty
    std::vector<glm::vec4> colors;            // #V linear RGBA, or empty
    std::vector<std::vector<glm::vec2>> uvs;  // sets, each #V; v goes up, as in OpenGL
    std::vector<std::uint32_t> points;        // #V to point of the surface, or empty: identity
    std::vector<std::uint32_t> corners;       // #C to vertex
    std::vector<std::uint32_t> face_begin{0}; // #F + 1 to corner
    std::vector<std::uint32_t> face_material; // #F to Model::materials, or empty: all 0
    std::vector<std::uint32_t> face_group;    // #F to group_names, or empty: none
    std::vector<std::string> group_names;
    struct Crease {         // for subdivision
        std::uint32_t a, b; // vertices at the ends of an edge; a == b: a corner
        float sharpness;    // 0 smooth, 10 and more: infinitely sharp
        bool operator==(const Crease&) const = default;
    };
    std::vector<Crease> creases;
    // Influences say how a pose moves a vertex; see core/mesh/pose.h. A mesh that was posed has
    // none.
    struct Influences {
        std::array<std::uint16_t, 4> joints{}; // of a skin
        glm::vec4 weights{1, 0, 0, 0};         // not negative, their sum 1
        bool operator==(const Influences&) const = default;
    };
    std::vector<Influences> influences; // #V, or empty: the mesh moves with its node
    struct MorphTarget {                // differences; each #V or empty: none
        std::vector<glm::vec3> positions, normals, tangents;
        bool operator==(const MorphTarget&) const = default;
    };
    std::vector<MorphTarget> morph_targets;

    std::size_t vertex_count() const { return positions.size(); }
    std::size_t face_count() const { return face_begin.size() - 1; }
    std::uint32_t point(std::uint32_t vertex) const
    {
        return points.empty() ? vertex : points[vertex];
    }
    bool operator==(const Mesh&) const = default;
};

Box bounding_box(const Mesh& mesh, const glm::dmat4& to_world = glm::dmat4(1));

// Adds a face at the end of `corners` and `face_begin`.
void add_face(Mesh& mesh, std::span<const std::uint32_t> vertices);

// Twice the area of a face times its unit normal (Newell's sum over its corners).
glm::dvec3 area_normal(const Mesh& mesh, std::size_t face);

// The table for Mesh::points in which vertices at exactly one position are one point. Points are
// numbered from 0 in the order of first appearance; O(#V).
std::vector<std::uint32_t> points_by_position(const std::vector<glm::vec3>& positions);

// The largest point number + 1: the length of a table by point.
std::size_t point_count(const Mesh& mesh);

// Gives the mesh other vertices: v gets all that vertex from[v] had. Corners are left as they are,
// creases name the first copies, and copies are one point.
void take_vertices(Mesh& mesh, const std::vector<std::uint32_t>& from);

// The mesh without the vertices that no face uses. The others keep their order and their points are
// numbered anew, as if the removed ones had never been there.
Mesh without_loose_vertices(Mesh mesh);

// #C - 2 #F by 3 vertex indices: face f's triangles are consecutive and begin at
// face_begin[f] - 2 f. Concave polygons are cut by ears, in the plane of their area normal.
std::vector<glm::uvec3> triangles(const Mesh& mesh);

// Area-weighted vertex normals, shared by the vertices of one point when they have no other
// reason to differ (`points`). #V unit; (0, 0, 1) where a vertex has no area around it.
std::vector<glm::vec3> smooth_normals(const Mesh& mesh);

// The mesh with every position, normal and tangent mapped by an affine matrix; a mirroring one
// also turns the faces round.
Mesh transformed(const Mesh& mesh, const glm::dmat4& matrix);

// Throws Rejected, with `name` in the sentence, unless every index is in range, every number
// finite and every face has at least three corners.
void validate(const Mesh& mesh, const std::string& name);

} // namespace trivar

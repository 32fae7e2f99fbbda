// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/born_vertices.h"
#include "core/refinement/composed_bounds.h"
#include "core/refinement/refine_part.h"

namespace trivar {

// SharedTriangles holds the triangles of several meshes in one volume, or in several that deform
// one after the other, with the points and edges that they share, so that an edge is split once for
// all triangles beside it. Two vertices are one point if their parameters are equal: seams, and
// boundaries between meshes, split alike on both sides.
class SharedTriangles {
public:
    using Index = std::uint32_t;
    static constexpr Index none = 0xffffffff;
    static constexpr double unknown = -1;

    struct Point {
        glm::dvec3 uvw{0}, displacement{0}, rest_world{0};
        int depth = 0; // number of splits that led to this vertex
        // The most that single precision may have changed: `moved` is the distance of its vertices
        // from the given flat triangles, in the object; `misplaced` their distance from where the
        // volume takes them, in the world.
        double moved = 0, misplaced = 0;
        glm::dvec3 last_world{0}; // where the last volume takes it
        glm::dvec3 first_world() const { return rest_world + displacement; }
    };
    struct Edge {
        Index a, b; // points
        double bound = unknown;
        float t = 0.5f; // the place at which to split it
        bool marked = false;
        Index middle = none; // the point there, once it is split
        Index halves = none; // the half at a; the half at b follows it
        Index first_twin = none;
    };
    struct Triangle {
        std::array<Index, 3> vertices, edges; // edge i from vertex i to the next one
        Index part, face;                     // of the given mesh
        double bound = unknown;
    };

    // `next` deform the result of the lattice.
    SharedTriangles(const std::vector<RefinePart>& parts, const Lattice& lattice,
                    const std::vector<NextVolume>& next);

    const std::vector<Point>& points() const { return points_; }
    std::vector<Edge>& edges() { return edges_; }
    const std::vector<Edge>& edges() const { return edges_; }
    std::vector<Triangle>& triangles() { return triangles_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    ComposedBounds::Simplex<2> simplex(const Edge& edge) const
    {
        return {{corner(edge.a), corner(edge.b)},
                {points_[edge.a].first_world(), points_[edge.b].first_world()}};
    }
    ComposedBounds::Simplex<3> simplex(const Triangle& triangle) const;
    double length_world(const Edge& edge) const; // length of the deformed chord
    // Distance of the deformed middle of an edge from the middle of its deformed chord.
    double middle_off(const Edge& edge) const;

    // Splits the marked edges, and their triangles into two, three (along the diagonal that is
    // shorter after deformation) or four. Afterwards no edge is marked, and the new edges stand
    // behind the others.
    void split_marked();

    // A part as a mesh of triangles, in their order; the given mesh itself where none was split.
    Ref<Mesh> mesh(std::size_t part) const;
    const std::vector<BornVertex>& born(std::size_t part) const { return parts_[part].all_born; }
    std::size_t part_count() const { return parts_.size(); }
    std::size_t triangles_before(std::size_t part) const { return triangles_before_[part]; }

private:
    // A Twin is a vertex on a split edge: one for every pair of vertices of a part at the edge's
    // ends.
    struct Twin {
        Index part, a, b, born, surface_point, next;
    };
    struct State {
        std::vector<Index> point_of;  // by vertex
        std::vector<BornVertex> born; // in this round
        std::vector<BornVertex> all_born;
        Index next_surface_point = 0; // for Mesh::points
        Mesh mesh;                    // only its vertices are kept up to date
        bool split = false;
    };
    ErrorBounds::Corner corner(Index point) const
    {
        return {points_[point].uvw, points_[point].displacement};
    }
    void take_vertices();
    void place(Point& point, const Embedding& embedding, const glm::dvec3& p_object) const;
    void take_triangles();
    void measure_places(std::size_t part, std::size_t first_vertex);
    void split_triangle(const Triangle& triangle, std::vector<Triangle>& out);
    Index add_edge(Index p, Index q);
    // The vertex on a split edge; it is made where it does not exist.
    Index vertex_on(Index edge, Index part, Index va, Index vb);

    const std::vector<RefinePart>& given_;
    const Lattice& lattice_;
    const std::vector<NextVolume>& next_;
    std::vector<State> parts_;
    std::vector<Point> points_;
    std::vector<Edge> edges_;
    std::vector<Twin> twins_; // in this round
    std::vector<Triangle> triangles_;
    std::vector<std::size_t> triangles_before_;
};

} // namespace trivar

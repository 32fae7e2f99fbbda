// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

inline constexpr int max_simplex_degree = 3;

// A SimplexDomain is a triangulation (S = 2) or tetrahedralisation (S = 3) of the parameters of a
// simplex spline, with a cloud of knots at each vertex:
//
//            2.
//           1. C              degree 2: knots 0 (the vertex), 1 and 2 at each corner
//             / \            a corner is a vertex of the cell
//        2   /   \            function (2, 0, 0) of the cell: knots A, A1, A2, B and C
//      1. . A-----B .1        function (1, 1, 0): knots A, A1, B, B1 and C
//                   .2
template <int S> struct SimplexDomain {
    using Point = glm::vec<S, double>;
    using Cell = std::array<int, S + 1>; // vertex numbers, of positive orientation

    int degree = 2; // 1..3
    // degree + 1 knots per vertex: the vertex, then its cloud
    std::vector<Point> knots;
    std::vector<Cell> cells;
    // faces across which no control point is shared, each with its vertices ascending
    std::vector<std::array<int, S>> cuts = {};
    // faces in whose plane are all knots of their vertices, and across which functions that take no
    // others share control points: the spline is continuous there, its slopes are not
    std::vector<std::array<int, S>> seams = {};

    int knots_per_vertex() const { return degree + 1; }
    std::size_t vertex_count() const
    {
        return knots.size() / static_cast<std::size_t>(knots_per_vertex());
    }
    const Point& knot(int vertex, int number) const
    {
        return knots[static_cast<std::size_t>(vertex * knots_per_vertex() + number)];
    }
    const Point& vertex(int number) const { return knot(number, 0); }
    bool operator==(const SimplexDomain&) const = default;
};

// The volume (S = 3) or area (S = 2) of a cell times S!, negative where it is inverted.
double orientation(const std::array<glm::dvec2, 3>& corners);
double orientation(const std::array<glm::dvec3, 4>& corners);

template <int S> auto corners(const SimplexDomain<S>& domain, std::size_t cell)
{
    std::array<glm::vec<S, double>, S + 1> out;
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = domain.vertex(domain.cells[cell][k]);
    return out;
}

// Throws Rejected with a sentence unless the degree is 1..3, all knots are finite, each cell names
// existing vertices and has positive orientation, no two vertices coincide, and the clouds do not
// cross: the simplex of knots (0, b_0), .. (S, b_S) has positive orientation for each b with
// sum b = degree. O(number of cells).
template <int S> void check(const SimplexDomain<S>& domain);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// The vertices and cells of a domain, before it has knots.
template <int S> struct SimplexMesh {
    std::vector<glm::vec<S, double>> vertices;
    std::vector<std::array<int, S + 1>> cells; // of positive orientation
    bool operator==(const SimplexMesh&) const = default;
};

// No maker of domains makes more cells than that, unless it is asked to.
inline constexpr std::size_t usual_cell_limit = 1'000'000;

// The least angle between two faces of any cell, in radians; 0 where a cell is flat or inverted.
// The regular tetrahedron has 1.23 (70.5 degrees). O(number of cells).
double least_dihedral(const SimplexMesh<3>& mesh);
double least_dihedral(const std::array<glm::dvec3, 4>& corners);

// The mesh of some cells (ascending numbers), with the vertices that they use in the same order.
SimplexMesh<3> part_of(const SimplexMesh<3>& mesh, const std::vector<int>& cells);

// The cells at each vertex, ascending.
std::vector<std::vector<int>> vertex_stars(const SimplexMesh<3>& mesh);

// Throws Rejected unless all vertices are finite and each cell names existing ones, is of positive
// orientation and shares each of its faces with at most one other. O(n log n).
void check(const SimplexMesh<3>& mesh);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_mesh.h"

#include <string>

namespace trivar {

// A closed or open surface of triangles.
struct TriangleSurface {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<int, 3>> triangles;
};

TriangleSurface torus(double around, double tube, int n, int m);
TriangleSurface sphere(int n);
TriangleSurface box_surface(const glm::dvec3& lo, const glm::dvec3& hi);

// Returns the fault of cells, as a sentence; empty: they make a domain of that degree, no face has
// three cells, and the border is a closed surface that meets itself nowhere.
std::string fault(const SimplexMesh<3>& mesh, int degree = 2);

inline constexpr double one_degree = 0.017453292519943295; // in radians

double volume(const SimplexMesh<3>& mesh);

// The most by which the sum of all functions misses 1, at that many places spread over each cell.
double sum_error(const SimplexMesh<3>& mesh, int degree, int per_cell, bool clamped = false);

} // namespace trivar

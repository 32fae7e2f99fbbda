// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"

namespace trivar::testing {

// Points all over the box [lo, hi]^3, with unit normals and tangents in all directions; no faces.
Mesh scattered_points(std::size_t count, float lo = 0, float hi = 1, unsigned seed = 1);

// Displacements up to `size` on every coordinate.
Lattice random_lattice(const std::array<Knots, 3>& axes, double size, unsigned seed = 1,
                       const glm::dmat4& rest = glm::dmat4(1));

// Knots with unequal spans over [0, 1], one of them twice.
Knots uneven_knots(int order);

// Rotation, unequal scale and shift.
glm::dmat4 some_affine_map();

// Deforms vertex by vertex in double.
Mesh deform_in_double(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice);

// Largest distance between positions, and between unit vectors.
double largest_distance(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b);

} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/deform.h"
#include "tests/support/splines.h"

#include <bit>

namespace trivar::testing {

// Points all over the box [lo, hi]^3, with unit normals and tangents in all directions; no faces.
Mesh scattered_points(std::size_t count, float lo = 0, float hi = 1, unsigned seed = 1);

// Displacements up to `size` on every coordinate.
inline Lattice random_lattice(const std::array<Knots, 3>& axes, double size, unsigned seed = 1)
{
    return {random_volume(axes, seed, size), glm::dmat4(1)};
}

// Rotation, unequal scale and shift.
glm::dmat4 some_affine_map();

// Deforms vertex by vertex in double.
Mesh deform_in_double(const Mesh& mesh, const Embedding& embedding, const Lattice& lattice);

// Tells -0 from 0, and one NaN from another.
template <class Vector>
std::vector<std::array<std::uint32_t, sizeof(Vector) / 4>> bits(const std::vector<Vector>& values)
{
    std::vector<std::array<std::uint32_t, sizeof(Vector) / 4>> out;
    for (const Vector& v : values)
        out.push_back(std::bit_cast<std::array<std::uint32_t, sizeof(Vector) / 4>>(v));
    return out;
}

// Largest distance between positions, and between unit vectors.
double largest_distance(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b);

// Between two directions, to the last digit also where it is small.
double angle_deg(const glm::dvec3& a, const glm::dvec3& b);

} // namespace trivar::testing

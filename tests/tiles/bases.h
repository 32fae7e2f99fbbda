// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/tiles/chart.h"
#include "core/tiles/layouter.h"

#include <random>

namespace trivar::testing {

TileBase base_of(Mesh mesh, const glm::dmat4& to_model = glm::dmat4(1));
// The pose in which the base is at rest.
BasePose at_rest(const TileBase& base);

// A random place, evenly spread over the triangles' numbers.
SurfacePlace random_place(const TileBase& base, std::mt19937& random);
glm::dvec3 random_tangent(const TileBase& base, const SurfacePlace& at, std::mt19937& random);

// A stroke over the places in which a straight line between two points, seen along `down`, meets
// the base.
TileStroke stroke_over(const TileBase& base, const glm::dvec3& from, const glm::dvec3& to,
                       const glm::dvec3& down, int samples);

} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace trivar {

// Only sources that use CGAL include this header.
using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalSurface = CGAL::Surface_mesh<CgalKernel::Point_3>;

// A surface as CGAL has it, with its faces turned outwards. Throws Rejected unless it is finite,
// closed, without flat faces, with two faces at each edge and one fan at each vertex, and does not
// cross itself. Vertices at one place are one. O(n log n), about 20 us per face.
CgalSurface closed_surface(std::span<const glm::dvec3> positions,
                           std::span<const std::array<int, 3>> triangles);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// A Disk is one chart: triangles whose only rim is one closed line.
struct Disk {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles; // of points, all of which they use
};

// The points of the rim in their order, counter-clockwise. O(#triangles log #triangles).
std::vector<std::uint32_t> rim_of(const Disk& disk);

// Returns the flat disk whose angles differ the least from those of the triangles: the least
// squares conformal map [1], up to a turn and a scale. Two points of the rim are held, and the rest
// is one solution of a sparse, symmetric system of 2 #points equations. A disk that can be unrolled
// without stretch is. Degenerate triangles count as if all edges were longer by a hair [2].
//   [1] Levy, Petitjean, Ray, Maillot, "Least squares conformal maps", 2002; in the form of Mullen,
//       Tong, Alliez, Desbrun, "Spectral conformal parameterization", 2008: half the Dirichlet
//       energy of both coordinates, less the area
//   [2] Sharp, Crane, "A Laplacian for nonmanifold triangle meshes", 2020, section 4.2
std::vector<glm::dvec2> conformal_map(const Disk& disk);

// The flat disk whose triangles differ the least from being moved and turned only, from `start` on:
// `rounds` times the rotation of each triangle, then all points [3]. It stretches less than the
// conformal map, and shears more.
//   [3] Liu, Zhang, Xu, Gotsman, Gortler, "A local/global approach to mesh parameterization", 2008
std::vector<glm::dvec2> rigid_map(const Disk& disk, std::vector<glm::dvec2> start, int rounds);

// The disk with its rim on a circle, each edge as long in share as it is. Only for a disk without
// other points, whose triangles then all have a positive area.
std::vector<glm::dvec2> circle_map(const Disk& disk);

// Whether a triangle is turned over or has no area, or the rim meets itself. If not, the map is one
// to one. O(#triangles), and up to O(#rim ^ 2).
bool is_folded(const Disk& disk, std::span<const glm::dvec2> map);

} // namespace trivar

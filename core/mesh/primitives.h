// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// Quad-dominant meshes with normals and texture coordinates, centred on the origin, Z up, closed
// where the shape is. Each throws Rejected for a size that is not positive and finite, or counts
// out of the range said.

Mesh plane_mesh(glm::dvec2 size, glm::ivec2 segments);    // segments 1..2000; in z = 0
Mesh box_mesh(glm::dvec3 size, glm::ivec3 segments);      // segments 1..500
Mesh sphere_mesh(double radius, int segments, int rings); // segments 3..2000, rings 2..1000
Mesh cylinder_mesh(double radius, double height, int segments, int stacks);
Mesh torus_mesh(double radius, double tube, glm::ivec2 segments); // around, across: 3..2000
// A band of constant width round a circle that turns over once: one side, one rim.
Mesh moebius_mesh(double radius, double width, glm::ivec2 segments);
// Newell's teapot from its 32 bicubic Bezier patches, each sampled resolution x resolution
// (1..64), scaled to the height given, standing on z = 0.
Mesh teapot_mesh(double height, int resolution);

} // namespace trivar

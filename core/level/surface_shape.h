// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/surface_bend.h"

#include <functional>

namespace trivar {

// A LocalShape is the shape of a surface at a place.
struct LocalShape {
    glm::vec3 normal{0}; // outward, unit; 0 where there is none
    SurfaceBend bend;
};

// A SurfaceShape is a surface as further lines see it, be it a level of a field or a mesh:
// triangles with the normal and the bend at each vertex.
struct SurfaceShape {
    std::vector<glm::vec3> positions;   // by vertex
    std::vector<glm::vec3> normals;     // outward, unit; 0 where there is none
    std::vector<SurfaceBend> bends;     // by vertex
    std::vector<std::uint32_t> corners; // three per triangle; an edge has at most two of them
    float size = 0;                     // diagonal of its box: what is large or small is told by it
    // The shape of the level through a place near the surface, if the surface is a level of a known
    // function. Bends are then compared over `step`, and not from vertex to vertex.
    std::function<LocalShape(const glm::vec3&)> at = {};
    float step = 0;
};

// The diagonal of the box round some places.
float size_of(std::span<const glm::vec3> positions);

// The bends averaged with those of neighbours so many times; each time is about half an edge wide.
void smooth_bends(SurfaceShape& shape, int times);

// The gradient of the linear function on a triangle, along the triangle; 0 where it is a line.
glm::vec3 triangle_gradient(const SurfaceShape& shape, std::size_t triangle,
                            const std::array<float, 3>& values);

// The gradients of a function at the vertices: those of the triangles there, by their areas.
std::vector<glm::vec3> vertex_gradients(const SurfaceShape& shape, std::span<const float> values);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <array>
#include <cstdint>

namespace trivar {

// A UvStretch is the effect on lengths of the map from a triangle to its texture coordinates: the
// largest and the smallest factor over all directions, the singular values of the map.
struct UvStretch {
    double most = 0, least = 0; // texture lengths per length; 0: the triangle has no area
    bool turned = false;        // the map is a mirror image
    double angle() const { return least > 0 ? most / least : 0; } // 1: all angles are kept
    double area() const { return most * least; }
};
UvStretch uv_stretch(const std::array<glm::dvec3, 3>& triangle,
                     const std::array<glm::dvec2, 3>& uv);

enum class UvMeasure { angles, areas };
// One number per vertex, the mean of the triangles round it by their areas; empty where the mesh
// has no texture coordinates. Of angles: the factor between the largest stretch and the smallest
// one, 1 or more. Of areas: the texture area per area, relative to that of all meshes, `usual`.
// Negative where triangles are turned over. O(#C).
std::vector<float> uv_values(const Mesh& mesh, UvMeasure measure, double usual = 1);
// The texture area of all triangles and their area.
struct UvAreas {
    double of_texture = 0, of_surface = 0;
};
UvAreas uv_areas(const Mesh& mesh);

} // namespace trivar

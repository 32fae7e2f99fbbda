// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/fine_triangles.h"

namespace trivar {

// CapOptions say how the holes that a cut leaves are closed.
struct CapOptions {
    // Two parameters in metres, (v, w), of each place on the cut surface. With the direction in
    // which the function of the cut grows they are right-handed.
    std::vector<glm::dvec2> places;
    // The point of the cut surface at two parameters, and its unit normal toward the part above.
    std::function<glm::dvec3(const glm::dvec2&)> point;
    std::function<glm::dvec3(const glm::dvec2&)> normal;
    // Triangles that are too coarse get points inside; null: none is. Those without an inner edge
    // longer than 1/1000 of the cap's size stay as they are.
    Coarseness coarseness = nullptr;
    std::uint32_t material = 0; // face_material of the caps
    // Runs beside the triangulation and looks at no vertex of the mesh; null: nothing.
    std::function<void()> meanwhile = nullptr;
};

} // namespace trivar

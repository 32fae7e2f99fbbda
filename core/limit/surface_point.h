// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace trivar {

// A SurfacePoint is a point of a surface in space, from which its place is found again on other
// triangles.
struct SurfacePoint {
    glm::dvec3 p{0}, normal{0, 0, 1}; // in the space of the surface's model, metres; unit
    bool operator==(const SurfacePoint&) const = default;
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A ViewPoint says from where a field is seen, in voxels: (direction of sight, 0) or (eye, 1).
struct ViewPoint {
    glm::dvec4 at{0, 0, 1, 0};
    // The direction of sight at a place, not unit. In double, since some compilers forget to round
    // a view to float and back.
    glm::dvec3 sight(const glm::dvec3& p) const
    {
        return at.w == 0 ? glm::dvec3(at) : p - glm::dvec3(at);
    }
};

// A point of a silhouette: D = level and <V, grad D> = 0.
struct SilhouettePoint {
    glm::vec3 p;            // voxels
    bool polished = false;  // else it is where the mesh has it, as the two surfaces touch there
    std::uint64_t edge = 0; // of the level's mesh, that it came from
    float bend = 0;         // <v, H v> / |grad D| for the unit direction of sight: above 0 the line
                            // of sight enters D > level on both sides of the point
    float slope = 0;        // |grad D|, per voxel
    float strength = 1;     // 0 .. 1, of a line that may fade: how distinct it is
};

// Silhouettes of a level in one view, as connected curves. They have no branches, and open ones end
// in the faces of the grid.
struct Silhouettes {
    std::vector<SilhouettePoint> points;
    std::vector<std::uint32_t> first{0}; // of each curve, and the end of the last
    std::vector<char> closed;            // by curve
    std::size_t count() const { return closed.size(); }
    std::size_t tested = 0, crossed = 0; // triangles: looked at, and with a change of sign
};

struct SilhouetteOptions {
    float spacing = 0.4f; // of points along a curve, voxels
    bool polished = true; // move points to the spline, by Newton's method
};

} // namespace trivar

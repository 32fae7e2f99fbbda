// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// A SurfaceDistance finds the nearest point of some triangles, which may be anything: open,
// crossing each other, flat or single points.
class SurfaceDistance {
public:
    // Vertex numbers must be in range, positions finite. At least one triangle. O(n log n).
    SurfaceDistance(std::span<const glm::dvec3> positions,
                    std::span<const std::array<int, 3>> triangles);

    // About 2 us for 10^5 triangles, less near the surface. Thread-safe.
    glm::dvec3 nearest(const glm::dvec3& x) const;

private:
    // Node n of the tree has children 2 n + 1 and 2 n + 2, and each leaf `leaf_size` triangles.
    struct Frame {
        std::array<glm::dvec3, 3> corners;
    };
    void build(std::size_t node, std::span<Frame> triangles);

    std::vector<Frame> triangles_;
    std::vector<Box> boxes_;
    std::size_t leaf_level_ = 0;
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/part.h"

#include <algorithm>

namespace trivar::testing {

// The greatest distance of the drawn triangles of a part in volumes from its true surface, sampled.
inline double drawn_off(const Part& part)
{
    const Mesh& flat = *innermost(part).before_volume();
    const Mesh& drawn = *part.mesh();
    constexpr int levels = 6;
    double most = 0;
    for (const glm::uvec3& t : triangles(flat))
        for (int i = 0; i <= levels; ++i)
            for (int j = 0; i + j <= levels; ++j) {
                const auto mixed = [&](const Mesh& mesh) {
                    return (double(i) * glm::dvec3(mesh.positions[t.x]) +
                            double(j) * glm::dvec3(mesh.positions[t.y]) +
                            double(levels - i - j) * glm::dvec3(mesh.positions[t.z])) /
                           double(levels);
                };
                most =
                    std::max(most, glm::distance(mixed(drawn), place_in_world(part, mixed(flat))));
            }
    return most;
}

} // namespace trivar::testing

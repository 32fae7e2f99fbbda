// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/node_parts.h"

#include <algorithm>
#include <cmath>

namespace trivar {

std::optional<NodeTransform> as_parts(const glm::dmat4& m)
{
    NodeTransform out;
    out.translation = glm::dvec3(m[3]);
    glm::dmat3 turn(m);
    for (int c = 0; c < 3; ++c) {
        out.scale[c] = glm::length(turn[c]);
        if (!(out.scale[c] > 0)) return {};
        turn[c] /= out.scale[c];
    }
    if (glm::determinant(turn) < 0) {
        out.scale.x = -out.scale.x;
        turn[0] = -turn[0];
    }
    out.rotation = glm::normalize(glm::quat_cast(turn));
    const glm::dmat4 again = out.matrix();
    constexpr double near_enough = 1e-6;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!(std::abs(again[c][r] - m[c][r]) <=
                  near_enough * std::max(1.0, glm::length(m[c]))))
                return {};
    return out;
}

} // namespace trivar

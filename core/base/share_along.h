// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace trivar {

// Finds where the segment from `from` along `way` is nearest to p, as a share 0 .. 1 of its length;
// 0 where it has none.
template <int N>
double share_along(const glm::vec<N, double>& p, const glm::vec<N, double>& from,
                   const glm::vec<N, double>& way)
{
    const double length2 = glm::dot(way, way);
    return length2 > 0 ? std::clamp(glm::dot(p - from, way) / length2, 0.0, 1.0) : 0;
}

} // namespace trivar

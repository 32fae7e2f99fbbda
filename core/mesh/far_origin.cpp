// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/far_origin.h"

#include <algorithm>
#include <cmath>

namespace trivar {

glm::dvec3 far_origin(const Box& box)
{
    constexpr double loss = 0x1p-24, allowed = 1e-5; // relative to a coordinate, and to the size
    if (box.empty()) return glm::dvec3(0);
    const glm::dvec3 far = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double most = loss * std::max({far.x, far.y, far.z});
    const double size = glm::length(box.size());
    if (!(most > allowed * size) || !std::isfinite(most)) return glm::dvec3(0);
    const double step = std::ldexp(1.0, std::ilogb(std::max(size, most)) + 1);
    return glm::round(box.center() / step) * step;
}

} // namespace trivar

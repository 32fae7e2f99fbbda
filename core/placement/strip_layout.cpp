// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/strip_layout.h"

namespace trivar {

std::vector<glm::dvec3> StripLayout::points() const
{
    std::vector<glm::dvec3> out(s.size());
    for (std::size_t k = 0; k < s.size(); ++k) out[k] = sheet.point(k, s);
    return out;
}

bool StripLayout::touches(std::size_t node) const
{
    return grid.hit[node] && s[node] <= 1e-6 * height;
}

} // namespace trivar

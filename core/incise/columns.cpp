// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/columns.h"

#include <algorithm>

namespace trivar {

glm::dvec3 SlitColumns::outward(std::uint32_t point) const
{
    const std::uint32_t n = number_.find(point);
    return n != KeyNumbers::none ? outward_[n] : inward_->outward(drawing_->point(point));
}

void SlitColumns::turn(std::uint32_t point, const glm::dvec3& outward)
{
    const auto [n, fresh] = number_.number(point);
    if (fresh) outward_.emplace_back();
    outward_[n] = outward;
}

double SlitColumns::sound_depth(std::uint32_t a, std::uint32_t b, double wanted, double share) const
{
    if (!number_.contains(a) && !number_.contains(b)) return wanted;
    const glm::dvec3 way = drawing_->position(b) - drawing_->position(a);
    const double nearer = glm::dot(way, outward(b) - outward(a)); // by so much per depth
    if (!(nearer > 0)) return wanted;
    return std::min(wanted, (1 - share) * glm::dot(way, way) / nearer);
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/line_distance.h"

#include "core/base/share_along.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

double squared(const glm::dvec3& v)
{
    return glm::dot(v, v);
}

double squared_to_box(const Box& box, const glm::dvec3& p)
{
    return squared(glm::max(glm::max(glm::dvec3(box.lo) - p, p - glm::dvec3(box.hi)), 0.0));
}

} // namespace

void LineDistance::add(std::span<const glm::dvec3> line)
{
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        if (pieces_.size() % block == 0) boxes_.emplace_back();
        pieces_.push_back({line[k], line[k + 1]});
        boxes_.back().add(line[k]);
        boxes_.back().add(line[k + 1]);
    }
}

double LineDistance::to(const glm::dvec3& p) const
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
        if (squared_to_box(boxes_[k], p) >= least) continue;
        const std::size_t end = std::min((k + 1) * block, pieces_.size());
        for (std::size_t i = k * block; i < end; ++i) {
            const auto& [a, b] = pieces_[i];
            const glm::dvec3 way = b - a;
            least = std::min(least, squared(a + share_along(p, a, way) * way - p));
        }
    }
    return std::sqrt(least);
}

} // namespace trivar

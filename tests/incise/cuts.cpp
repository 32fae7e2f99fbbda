// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/incise/cuts.h"

namespace trivar::testing {

Incision cut_on_sphere(const std::vector<glm::dvec3>& through, double depth, double width)
{
    constexpr int samples = 12; // from one direction to the next
    Incision cut;
    cut.depth = depth;
    cut.width = width;
    for (std::size_t i = 0; i + 1 < through.size(); ++i)
        for (int k = i == 0 ? 0 : 1; k <= samples; ++k) {
            const double t = static_cast<double>(k) / samples;
            const glm::dvec3 n = glm::normalize((1 - t) * glm::normalize(through[i]) +
                                                t * glm::normalize(through[i + 1]));
            cut.stroke.push_back({n, n});
        }
    return cut;
}

std::vector<Incision> crossing_cuts_on_sphere()
{
    return {cut_on_sphere({{1, -0.4, 0.03}, {1, 0.4, -0.02}}),
            cut_on_sphere({{1, 0.03, -0.4}, {1, -0.02, 0.4}})};
}

} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/part.h"

#include <gtest/gtest.h>

namespace trivar::testing {

// The places of a part's vertices in the world.
inline std::vector<glm::vec3> world_points(const Part& part)
{
    std::vector<glm::vec3> out;
    for (const glm::vec3& p : part.mesh()->positions)
        out.emplace_back(part.to_world * glm::dvec4(p, 1));
    return out;
}

// The greatest distance of two lists of equally many places.
inline double most_apart(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    EXPECT_EQ(a.size(), b.size());
    if (a.size() != b.size()) return 1e30;
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max<double>(most, glm::distance(a[i], b[i]));
    return most;
}

} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/greville_grid.h"

#include "core/spline/fit.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

TEST(GrevilleGrid, InterpolatesAndEvaluatesAsTheGeneralFunctionsDo)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int order = 2; order <= max_order; ++order) {
        const std::array<Knots, 2> axes{Knots::uniform(order, 11),
                                        Knots::uniform(std::max(2, order - 1), 6)};
        std::vector<glm::dvec3> values(66);
        for (glm::dvec3& p : values) p = {uniform(random), uniform(random), uniform(random)};
        const GrevilleGrid grid(axes);
        const Surface<glm::dvec3> s = grid.through(values), expected = interpolate(axes, values);
        const auto jets = grid.jets(s.points, 2);
        for (int i = 0; i < 11; ++i)
            for (int j = 0; j < 6; ++j) {
                const std::size_t k = s.index(i, j);
                EXPECT_LT(glm::distance(s.points[k], expected.points[k]), 1e-11);
                const auto jet = evaluate(s, {axes[0].greville(i), axes[1].greville(j)}, 2);
                EXPECT_LT(glm::distance(jets[k].value, values[k]), 1e-11);
                EXPECT_LT(glm::distance(jets[k].u, jet.u), 1e-9);
                EXPECT_LT(glm::distance(jets[k].v, jet.v), 1e-9);
                EXPECT_LT(glm::distance(jets[k].uu, jet.uu), 1e-7);
                EXPECT_LT(glm::distance(jets[k].uv, jet.uv), 1e-7);
                EXPECT_LT(glm::distance(jets[k].vv, jet.vv), 1e-7);
            }
    }
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/limit/cages.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

TEST(ChartWalks, ComeBackByTheWayTheyWent)
{
    std::mt19937 random(1);
    std::normal_distribution<double> number(0, 1.5);
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        const LimitSurface surface = limit_of(cage.mesh);
        const ChartNet& net = surface.net();
        for (int k = 0; k < 2000; ++k) {
            const ChartPlace from = random_chart_place(surface, random);
            const ChartNet::Walk there = net.walk(from, {number(random), number(random)});
            if (there.left > 0) {
                EXPECT_EQ(net.across(there.at.chart, there.edge).chart, ChartNet::none);
                continue;
            }
            const ChartNet::Walk back = net.walk(there.at, -there.step);
            EXPECT_EQ(back.at.chart, from.chart);
            EXPECT_LT(glm::distance(back.at.uv, from.uv), 1e-13);
            EXPECT_EQ((there.turns + back.turns) & 3, 0);
        }
    }
}

TEST(ChartWalks, RoundATorusCloseExactly)
{
    const ChartNet net = limit_of(torus_cage()).net();
    for (std::uint32_t c = 0; c < net.size(); ++c)
        for (int e = 0; e < 4; ++e) {
            // The walk goes as many charts ahead as lie round the torus that way.
            const ChartPlace from{c, {0.5, 0.25}};
            int round = 0;
            ChartPlace at = from;
            glm::dvec2 step = out_of_edge(e);
            do {
                const ChartNet::Walk walk = net.walk(at, step);
                at = walk.at;
                step = walk.step;
                ++round;
            } while (at.chart != c && round < 100);
            EXPECT_TRUE(round == 12 || round == 6);
            EXPECT_EQ(at.uv, from.uv);
            EXPECT_EQ(step, out_of_edge(e));
        }
}

TEST(ChartWalks, StopOnBordersAndOnDemandOnCreases)
{
    const ChartNet plane = limit_of(plane_cage()).net();
    const ChartNet::Walk out = plane.walk({0, glm::dvec2(0.5)}, {100, 0});
    ASSERT_GE(out.edge, 0);
    EXPECT_GT(out.left, 0.9);
    EXPECT_TRUE(out.at.uv.x == 0 || out.at.uv.x == 1 || out.at.uv.y == 0 || out.at.uv.y == 1);

    const ChartNet box = limit_of(sharp_box_cage()).net();
    const ChartNet::Walk stopped = box.walk({4, {0.3, 0.6}}, {7, 0}, false);
    ASSERT_GE(stopped.edge, 0);
    EXPECT_TRUE(box.is_crease(stopped.at.chart, stopped.edge));
    EXPECT_EQ(box.walk({4, {0.3, 0.6}}, {7, 0}, true).left, 0);
}

TEST(ChartWalks, EndForAnyNumbers)
{
    const ChartNet net = limit_of(torus_cage()).net();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    net.walk({0, glm::dvec2(0.5)}, {1e300, 1e300});
    net.walk({0, glm::dvec2(nan)}, {1, 1});
    net.walk({0, glm::dvec2(0.5)}, {nan, 1});
}

TEST(ChartNets, TakeEdgesOfMoreThanTwoFacesForBorders)
{
    // Three quads round one edge.
    const std::vector<int> corners{0, 1, 2, 3, 1, 0, 4, 5, 0, 1, 6, 7};
    const ChartNet net(corners, {});
    for (std::uint32_t c = 0; c < 3; ++c)
        for (int e = 0; e < 4; ++e) EXPECT_EQ(net.across(c, e).chart, ChartNet::none);
}

} // namespace
} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/height_map.h"

#include "core/base/rejected.h"
#include "core/placement/profile.h"
#include "core/placement/round.h"
#include "tests/placement/scenes.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace ::testing;
using namespace trivar::testing;

const HeightGrid hilly{{0.5, 0.8, 0.5, 0.6}, {1, 2, 1.5, 1}, {0.6, 1.2, 0.4, 0.3}};

TEST(HeightMap, IsOneWithoutAGridAndTheFactorWhereAllAreOne)
{
    EXPECT_EQ(HeightMap().at(0.3, 0.7), 1);
    const HeightMap even(HeightGrid(4, std::vector<double>(7, 1.3)));
    for (int i = 0; i <= 10; ++i) EXPECT_EQ(even.at(i / 10.0, 1 - i / 10.0), 1.3);
    EXPECT_EQ(even.largest(), 1.3);
}

TEST(HeightMap, MeetsItsCornersAndNeverLeavesTheRangeOfItsValues)
{
    const HeightMap map(hilly);
    EXPECT_EQ(map.at(0, 0), 0.5);
    EXPECT_EQ(map.at(0, 1), 0.6);
    EXPECT_EQ(map.at(1, 0), 0.6);
    EXPECT_EQ(map.at(1, 1), 0.3);
    EXPECT_EQ(map.at(-1, 2), map.at(0, 1));
    for (int i = 0; i <= 50; ++i)
        for (int j = 0; j <= 50; ++j) {
            EXPECT_GE(map.at(i / 50.0, j / 50.0), 0.3);
            EXPECT_LE(map.at(i / 50.0, j / 50.0), map.largest());
        }
}

// A profile whose points stand at the Greville abscissae is the same spline along one axis.
TEST(HeightMap, OfAnOuterProductIsTheProductOfTheProfiles)
{
    const std::vector<double> a{0.4, 1.2, 1, 0.7, 2}, b{1, 0.3, 1.5};
    HeightGrid grid;
    for (const double along : a) {
        grid.emplace_back();
        for (const double across : b) grid.back().push_back(along * across);
    }
    const HeightMap map(grid);
    std::vector<glm::dvec2> along, across;
    for (std::size_t i = 0; i < a.size(); ++i) along.emplace_back(map.along()[i], a[i]);
    for (std::size_t j = 0; j < b.size(); ++j) across.emplace_back(map.across()[j], b[j]);
    const Profile of_u(along), of_v(across);
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j)
            EXPECT_NEAR(map.at(i / 40.0, j / 40.0), of_u.at(i / 40.0) * of_v.at(j / 40.0), 1e-13);
    PlacementParameters both{.height = 0.1}, one = both;
    both.height_profile = along;
    both.height_across = across;
    one.height_map = grid;
    const Lattice x = over_waves(both).volume, y = over_waves(one).volume;
    ASSERT_EQ(x.displacement.points.size(), y.displacement.points.size());
    for (std::size_t i = 0; i < x.displacement.points.size(); ++i)
        EXPECT_LT(glm::distance(x.displacement.points[i], y.displacement.points[i]), 1e-13);
}

TEST(HeightMap, ResampledOnMorePointsKeepsItsEndsAndItsRange)
{
    const HeightMap before(hilly), same(resampled(hilly, 3, 4)), finer(resampled(hilly, 32, 32));
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j)
            EXPECT_NEAR(finer.at(i / 20.0, j / 20.0), before.at(i / 20.0, j / 20.0), 0.02);
    EXPECT_EQ(finer.at(0, 1), before.at(0, 1));
    EXPECT_LE(same.largest(), before.largest());
    EXPECT_EQ(resampled({}, 2, 2), (HeightGrid{{1, 1}, {1, 1}}));
}

TEST(HeightMap, SaysWhatIsWrong)
{
    const auto refuses = [](const HeightGrid& grid, const char* words) {
        EXPECT_THAT([&] { check_height_map(grid, "the map"); },
                    ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    refuses({{1, 1}}, "the map has 1 values along the stroke");
    refuses({{1}, {1}}, "1 values across");
    refuses({{}, {}}, "0 values across");
    refuses({{1, 1}, {1, 1, 1}}, "rows of 2 and of 3 values");
    refuses({{1, 1}, {1, 0}}, "the factor 0");
    refuses({{1, 1}, {1, std::nan("")}}, "the factor not a number");
    refuses(HeightGrid(33, std::vector<double>(2, 1)), "33 values along");
    EXPECT_NO_THROW(check_height_map({}, "the map"));
}

TEST(Place, IsSoManyTimesAsHighWithAnEvenHeightMap)
{
    for (const double offset : {0.0, 1.0}) {
        PlacementParameters even{.height = 0.1, .offset = offset}, profile = even;
        even.height_map = HeightGrid(3, std::vector<double>(2, 1.5));
        profile.height_profile = {{0, 1.5}, {1, 1.5}};
        EXPECT_EQ(over_waves(even).volume, over_waves(profile).volume);
        even.height_map = {{1, 1}, {1, 1}};
        EXPECT_EQ(over_waves(even).volume, over_waves({.height = 0.1, .offset = offset}).volume);
    }
}

TEST(Place, HasTheHeightOfTheMapAtItsNodesAndDoesNotFold)
{
    PlacementParameters p{.height = 0.1};
    p.height_map = hilly;
    p.height_profile = {{0, 0.5}, {0.4, 1.4}, {1, 0.3}};
    const Placement out = over_waves(p);
    const HeightMap map(hilly);
    const Profile along(p.height_profile);
    const auto& axes = out.contact.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j) {
            const double u = axes[0].greville(i), v = axes[1].greville(j);
            const glm::dvec3 floor = evaluate(out.volume, {u, v, 0}).value;
            EXPECT_NEAR(glm::distance(evaluate(out.volume, {u, v, 1}).value, floor),
                        0.1 * along.at(u) * map.at(u, v), 1e-12);
        }
    for (int i = 0; i <= 60; ++i)
        for (int j = 0; j <= 20; ++j) {
            const auto f = evaluate(out.volume, {i / 60.0, j / 20.0, 0.5}, 1).first;
            EXPECT_GT(glm::determinant(glm::dmat3(f[0], f[1], f[2])), 0);
        }
}

TEST(Round, HasTheHeightOfTheMapAndRefusesOneOnAMoebiusBand)
{
    PlacementParameters p{.grid = {48, 8, 4}, .orders = {4, 4, 3}, .fill = 1.0 / 6};
    p.height_map = {{1, 1.5, 1}, {0.5, 1, 0.8}, {0.6, 1, 1}, {1, 1.5, 1}};
    const Placement out = place_round({.radius = 2}, p, snake_box());
    const HeightMap map(p.height_map);
    for (const glm::dvec2 uv : {glm::dvec2(0.3, 0.2), {0.6, 0.5}, {0.8, 1}})
        EXPECT_NEAR(glm::distance(evaluate(out.volume, {uv.x, uv.y, 1}).value,
                                  evaluate(out.volume, {uv.x, uv.y, 0}).value),
                    out.report.height_world * map.at(uv.x, uv.y), 0.01 * out.report.height_world);
    EXPECT_THROW(place_round({.of = Band::Of::moebius, .radius = 2}, p, snake_box()), Rejected);
}

} // namespace
} // namespace trivar

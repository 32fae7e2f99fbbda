// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/casting/transfer_table.h"
#include "core/voxels/usual_level.h"
#include "tests/casting/volumes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

TEST(TransferFunctions, GoStraightFromPointToPointInAnyOrder)
{
    const std::vector<TransferPoint> points{{20, {0, 0, 1}, 0.5}, {10, {1, 0, 0}, 0.1}};
    EXPECT_EQ(transfer_at(points, 5), glm::vec4(1, 0, 0, 0.1f));
    EXPECT_EQ(transfer_at(points, 30), glm::vec4(0, 0, 1, 0.5f));
    EXPECT_NEAR(transfer_at(points, 15).a, 0.3, 1e-6);
    EXPECT_NEAR(transfer_at(points, 15).r, 0.5, 1e-6);
    EXPECT_EQ(transfer_at({}, 15), glm::vec4(0));
}

TEST(TransferFunctions, StepAtTwoPointsOfOneValue)
{
    const std::vector<TransferPoint> points{{10, {1, 0, 0}, 0}, {10, {1, 0, 0}, 1}};
    EXPECT_EQ(transfer_at(points, 9.99).a, 0);
    EXPECT_EQ(transfer_at(points, 10).a, 1);
}

TEST(TransferFunctions, AreDrawnByTheMiddlesOfTheirParts)
{
    const auto colors = transfer_colors(red_and_blue(), 0, 256);
    for (const std::size_t i : {0, 100, 130, 255})
        EXPECT_EQ(colors[i], transfer_at(red_and_blue(), static_cast<double>(i) + 0.5));
}

TEST(TransferFunctions, ThatAreMadeFromAHistogramAreEmptyBelowTheLevelThatPartsIt)
{
    // Air, tissue and bone.
    const auto head = [](const glm::dvec3& p) {
        const double r = glm::distance(p, glm::dvec3(16));
        return r < 5 ? 180 + r : r < 12 ? 90 + r / 2 : 5 + r / 9;
    };
    const Ref<VoxelGrid> grid = bytes_of({33, 33, 33}, head);
    const VolumeSummary summary = summary_of(*grid);
    const std::vector<TransferPoint> points = usual_transfer(summary, *grid);
    EXPECT_EQ(transfer_at(points, 8).a, 0) << "air";
    EXPECT_GT(transfer_at(points, 182).a, 0.4) << "bone";
    EXPECT_GT(transfer_at(points, 95).a, 0) << "tissue";
    EXPECT_LT(transfer_at(points, 95).a, 0.06);
    EXPECT_TRUE(std::ranges::is_sorted(points, {}, &TransferPoint::value));
}

TEST(TransferFunctions, OfDataWithOneValueAreDefined)
{
    const Ref<VoxelGrid> grid = bytes_of({4, 4, 4}, [](const glm::dvec3&) { return 7.0; });
    for (const TransferPoint& point : usual_transfer(summary_of(*grid), *grid)) {
        EXPECT_TRUE(std::isfinite(point.value));
        EXPECT_GE(point.opacity, 0);
    }
}

TEST(TransferTables, HoldTheDensityBetweenTwoValues)
{
    const TransferTable table =
        transfer_table(std::vector<TransferPoint>{{0, {1, 1, 1}, 0.5}}, 0, 100);
    const double density = -std::log(0.5);
    EXPECT_NEAR(table.before.back().a, density, 1e-5);
    EXPECT_NEAR(table.before[512].a, density / 2, 1e-5);
    EXPECT_NEAR(table.before.back().r, density, 1e-5);
}

TEST(TransferTables, TellWhereNothingIsSeen)
{
    const TransferTable table = transfer_table(red_and_blue(), 0, 200);
    EXPECT_TRUE(table.empty(0, 0.44));
    EXPECT_FALSE(table.empty(0, 0.46));
    EXPECT_FALSE(table.empty(0.9, 1));
}

} // namespace
} // namespace trivar::testing

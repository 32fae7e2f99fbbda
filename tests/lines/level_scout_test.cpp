// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/level_scout.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "tests/field/fields.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

// A ball of value 10 in one of 4 in 0, with soft walls.
VoxelGrid balls(int n)
{
    VoxelGrid out;
    out.size = glm::ivec3(n);
    std::vector<float> samples;
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const double r = glm::length(glm::dvec3(x, y, z) * (2.0 / (n - 1)) - 1.0);
                const auto wall = [&](double radius) {
                    return 0.5 - 0.5 * std::tanh((r - radius) * 12);
                };
                samples.push_back(static_cast<float>(4 * wall(0.8) + 6 * wall(0.3)));
            }
    out.samples = std::move(samples);
    return out;
}

TEST(LevelScouts, FindBodiesAsPlateausOfTheLengthOfTheirLines)
{
    const LevelScout scout = scout_levels(balls(48));
    ASSERT_EQ(scout.values.size(), 64u);
    EXPECT_TRUE(std::ranges::is_sorted(scout.values));
    const auto plateau_in = [&](double lo, double hi) {
        return std::ranges::any_of(scout.plateaus, [&](std::size_t i) {
            return scout.values[i] > lo && scout.values[i] < hi;
        });
    };
    EXPECT_TRUE(plateau_in(0.5, 3.8));
    EXPECT_TRUE(plateau_in(4.2, 9.8));
    const auto length_at = [&](double value) {
        return scout.lengths[static_cast<std::size_t>(value / 10 * 64)];
    };
    const double unit = 47.0 / 2 * 2 * 3.14159; // voxels, of a great circle of radius 1
    EXPECT_NEAR(length_at(2), 0.8 * unit, 0.03 * unit);
    EXPECT_NEAR(length_at(7), 0.3 * unit, 0.03 * unit);
}

// Noise of 0 to 0.5 in what is 0 else has far more line than the bodies.
TEST(LevelScouts, TakeNoPeakOfNoiseForABody)
{
    VoxelGrid grid = balls(48);
    std::mt19937 random(1);
    for (float& sample : std::get<std::vector<float>>(grid.samples))
        sample += static_cast<float>(random() % 1000) / 2000;
    const LevelScout scout = scout_levels(grid);
    const std::size_t peak =
        static_cast<std::size_t>(std::ranges::max_element(scout.lengths) - scout.lengths.begin());
    EXPECT_LT(scout.values[peak], 0.5);
    ASSERT_FALSE(scout.plateaus.empty());
    EXPECT_GT(scout.values[scout.plateaus.front()], 0.5);
    EXPECT_LT(scout.lengths[scout.plateaus.front()], scout.lengths[peak] / 4);
    EXPECT_GT(scout.values[scout.plateaus.back()], 4.6);
}

TEST(LevelScouts, AreTheSameForAnyNumberOfThreadsAndAverageLargeGrids)
{
    const LevelScout all = scout_levels(balls(70), 16, 32);
    const ThreadLimit one(1);
    EXPECT_EQ(all.lengths, scout_levels(balls(70), 16, 32).lengths);
    EXPECT_GT(all.lengths[4], 0);
}

TEST(LevelScouts, StopWhenTheyAreCancelled)
{
    int asked = 0;
    const Progress stop = [&](double, std::string_view) {
        if (++asked == 3) throw Cancelled();
    };
    EXPECT_THROW(scout_levels(balls(24), 16, 32, stop), Cancelled);
    EXPECT_EQ(asked, 3);
}

} // namespace
} // namespace trivar::testing

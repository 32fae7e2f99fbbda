// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_summary.h"

#include "core/base/parallel.h"
#include "tests/voxels/volume_files.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace trivar {
namespace {

TEST(VolumeSummary, SaysWhatIsShown)
{
    const VolumeSummary summary = summary_of(testing::small_volume());
    EXPECT_EQ(summary.size, glm::ivec3(5, 4, 3));
    EXPECT_EQ(summary.type, "signed 16-bit whole numbers");
    EXPECT_EQ(summary.bytes, 120u);
    EXPECT_NEAR(summary.spacing_mm.y, 0.8, 1e-12);
    EXPECT_EQ(summary.least, 0);
    EXPECT_EQ(summary.greatest, 63);
    EXPECT_EQ(std::accumulate(summary.histogram.begin(), summary.histogram.end(), std::uint64_t{0}),
              60u);
    EXPECT_EQ(summary.histogram[0], 1u);
    EXPECT_EQ(summary.histogram[255], 1u);
}

TEST(VolumeSummary, TurnsWithANegativeSlope)
{
    VoxelGrid grid = testing::small_volume();
    grid.samples = std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 10};
    grid.size = {2, 2, 2};
    grid.slope = -2;
    const VolumeSummary summary = summary_of(grid);
    EXPECT_EQ(summary.least, -20);
    EXPECT_EQ(summary.greatest, 0);
    EXPECT_EQ(summary.histogram[0], 1u);
    EXPECT_EQ(summary.histogram[255], 7u);
}

TEST(VolumeSummary, LeavesOutWhatIsNotFinite)
{
    VoxelGrid grid;
    grid.size = {2, 2, 2};
    grid.samples = std::vector<float>{1, 2, 3, 4, 5, 6, NAN, INFINITY};
    const VolumeSummary summary = summary_of(grid);
    EXPECT_EQ(summary.not_finite, 2u);
    EXPECT_EQ(summary.least, 1);
    EXPECT_EQ(summary.greatest, 6);
}

TEST(VolumeSummary, IsTheSameForAnyNumberOfThreads)
{
    VoxelGrid grid;
    grid.size = {200, 200, 100};
    std::vector<float> samples(grid.count());
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<float>(std::sin(static_cast<double>(i)));
    grid.samples = samples;
    const VolumeSummary many = summary_of(grid);
    const ThreadLimit one(1);
    EXPECT_EQ(summary_of(grid), many);
}

} // namespace
} // namespace trivar

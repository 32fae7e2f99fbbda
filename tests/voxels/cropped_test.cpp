// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/cropped.h"

#include <gtest/gtest.h>
#include <numeric>

namespace trivar {
namespace {

VoxelGrid numbered(const glm::ivec3& size)
{
    VoxelGrid out;
    out.size = size;
    std::vector<std::int16_t> samples(out.count());
    std::iota(samples.begin(), samples.end(), std::int16_t{-50});
    out.samples = samples;
    out.slope = 2;
    out.value_unit = "HU";
    out.to_metres = {{0.001, 0, 0, 0}, {0, 0.002, 0.001, 0}, {0, 0, 0.003, 0}, {4, 5, 6, 1}};
    return out;
}

TEST(CroppedVolumes, HaveTheSameSamplesAtTheSamePlaces)
{
    const VoxelGrid whole = numbered({7, 6, 5});
    const SampleBox box{{2, 1, 0}, {5, 4, 3}};
    const VoxelGrid part = cropped(whole, box);
    ASSERT_EQ(part.size, glm::ivec3(4, 4, 4));
    EXPECT_EQ(part.value(3), whole.value(3));
    EXPECT_EQ(part.value_unit, "HU");
    const auto& samples = std::get<std::vector<std::int16_t>>(part.samples);
    ASSERT_EQ(samples.size(), part.count());
    const glm::dmat4 to_whole = glm::inverse(whole.to_metres) * part.to_metres;
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const glm::ivec3 at(glm::round(to_whole * glm::dvec4(i, j, k, 1)));
                EXPECT_EQ(at, box.first + glm::ivec3(i, j, k));
                EXPECT_EQ(samples[static_cast<std::size_t>(i + 4 * (j + 4 * k))],
                          at.x + 7 * (at.y + 6 * at.z) - 50);
            }
}

TEST(CroppedVolumes, OfAllSamplesAreTheSame)
{
    const VoxelGrid whole = numbered({7, 6, 5});
    const SampleBox all = sample_box(whole.size, glm::vec3(0), glm::vec3(1));
    EXPECT_EQ(all, (SampleBox{{0, 0, 0}, {6, 5, 4}}));
    EXPECT_EQ(cropped(whole, all), whole);
}

TEST(CroppedVolumes, TakeTheNearestSamplesAndTwoOfEachAxisAtLeast)
{
    const glm::ivec3 size(11, 11, 2);
    EXPECT_EQ(sample_box(size, {0.24f, 0.5f, 0.1f}, {0.76f, 0.51f, 0.2f}),
              (SampleBox{{2, 5, 0}, {8, 6, 1}}));
    EXPECT_EQ(sample_box(size, glm::vec3(1), glm::vec3(0)), (SampleBox{{9, 9, 0}, {10, 10, 1}}));
}

} // namespace
} // namespace trivar

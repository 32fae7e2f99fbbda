// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/coarsened.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// Samples that are 2 x + 3 y - z + 10, with spacings of 1, 2 and 3 mm.
VoxelGrid sloped(const glm::ivec3& size)
{
    VoxelGrid out;
    out.size = size;
    std::vector<float> samples;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                samples.push_back(static_cast<float>(2 * x + 3 * y - z + 10));
    out.samples = samples;
    out.to_metres = glm::dmat4(glm::dmat3(0.001, 0, 0, 0, 0.002, 0, 0, 0, 0.003));
    return out;
}

TEST(CoarsenedVolumes, HaveTheSameValuesAtTheSamePlaces)
{
    const VoxelGrid fine = sloped({12, 9, 7}), coarse = coarsened(fine, glm::ivec3(3));
    EXPECT_EQ(coarse.size, glm::ivec3(4, 3, 2));
    const auto& samples = std::get<std::vector<float>>(coarse.samples);
    const glm::dmat4 to_fine = glm::inverse(fine.to_metres) * coarse.to_metres;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 4; ++x) {
                const glm::dvec3 p(to_fine * glm::dvec4(x, y, z, 1));
                EXPECT_NEAR(samples[static_cast<std::size_t>(x + 4 * (y + 3 * z))],
                            2 * p.x + 3 * p.y - p.z + 10, 1e-4);
            }
}

TEST(CoarsenedVolumes, KeepTheKindOfSamplesAndTwoOfEachAxis)
{
    VoxelGrid fine = sloped({6, 3, 2});
    fine.samples = std::vector<std::int16_t>(36, -7);
    const VoxelGrid coarse = coarsened(fine, glm::ivec3(4));
    EXPECT_EQ(coarse.size, glm::ivec3(2, 3, 2));
    EXPECT_EQ(coarse.samples, VoxelGrid::Samples(std::vector<std::int16_t>(12, -7)));
    EXPECT_EQ(coarsened(fine, glm::ivec3(1)), fine);
}

} // namespace
} // namespace trivar

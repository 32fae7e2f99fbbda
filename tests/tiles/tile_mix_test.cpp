// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_mix.h"

#include <array>
#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(TileMix, ComesAsOftenAsTheWeightsSay)
{
    const std::array<double, 4> weights{1, 0, 3, 4};
    std::array<int, 4> counts{};
    constexpr int tiles = 40'000;
    for (std::uint32_t seed = 0; seed < tiles; ++seed)
        ++counts[kind_of(seed * 2654435761u + 17, weights)];
    EXPECT_EQ(counts[1], 0);
    EXPECT_NEAR(counts[0], tiles / 8.0, 300);
    EXPECT_NEAR(counts[2], tiles * 3 / 8.0, 400);
    EXPECT_NEAR(counts[3], tiles / 2.0, 400);
}

TEST(TileMix, IsTheFirstKindWhereNothingElseCanBe)
{
    EXPECT_EQ(kind_of(5, {}), 0u);
    EXPECT_EQ(kind_of(5, std::array<double, 2>{0, 0}), 0u);
    EXPECT_EQ(kind_of(5, std::array<double, 2>{0, 1}), 1u);
}

// Where one weight grows, tiles only change to that kind; others never change places.
TEST(TileMix, ChangesNoMoreThanItMust)
{
    const std::array<double, 2> before{1, 1}, after{1, 2};
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        if (kind_of(seed, before) == 1) {
            EXPECT_EQ(kind_of(seed, after), 1u);
        }
    }
}

} // namespace
} // namespace trivar

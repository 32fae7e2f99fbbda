// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/casting/cast_image.h"
#include "tests/casting/volumes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// A ball with a hole from one side down to its middle.
Casting hollow_ball()
{
    const auto value = [](const glm::dvec3& p) {
        const glm::dvec3 d = p - 32.0;
        const bool hole = d.z > 0 && d.x * d.x + d.y * d.y < 36;
        return glm::length(d) < 24 && !hole ? 200.0 : 0.0;
    };
    return casting_of(field_of(bytes_of(glm::ivec3(65), value), FieldOrder::linear),
                      std::vector<TransferPoint>{{90, {1, 1, 1}, 0}, {110, {1, 1, 1}, 0.5}}, 0,
                      200);
}

int open_share(const Casting& casting, const glm::ivec3& brick)
{
    const glm::ivec3 n = casting.open.count;
    return casting.open.share[static_cast<std::size_t>(brick.x + n.x * (brick.y + n.y * brick.z))];
}

TEST(OpenBricks, AreDarkWithinHalfOpenOnTheSkinAndBrightOutside)
{
    const Casting ball = hollow_ball();
    EXPECT_LT(open_share(ball, {5, 8, 5}), 8) << "deep within";
    EXPECT_GT(open_share(ball, {8, 1, 8}), 100) << "before the skin";
    EXPECT_LT(open_share(ball, {8, 1, 8}), 200);
    EXPECT_EQ(open_share(ball, {0, 0, 0}), 255) << "in a corner";
}

TEST(OpenBricks, AreDarkerInAHoleThanOnTheSkin)
{
    const Casting ball = hollow_ball();
    EXPECT_LT(open_share(ball, {8, 8, 9}), 60);
    EXPECT_GT(open_share(ball, {8, 8, 9}), 10) << "its mouth is open";
}

TEST(OpenBricks, AreTheSameForAnyNumberOfThreads)
{
    const Casting many = hollow_ball();
    const ThreadLimit one(1);
    EXPECT_EQ(hollow_ball().open.share, many.open.share);
}

} // namespace
} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_uv_transform.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

constexpr double quarter = 1.5707963267948966, exact = 1e-6; // radians; single precision

void expect_at(const glm::vec2& moved, double u, double v)
{
    EXPECT_NEAR(moved.x, u, exact);
    EXPECT_NEAR(moved.y, v, exact);
}

// "This example utilizes only the lower left quadrant of the source image, rotated clockwise 90
// degrees": the first example of KHR_texture_transform. As v goes down, the quadrant is u 0 to 1/2
// and v 1/2 to 1. By hand: scaled (u/2, v/2); turned, cos 0 and sin 1, (v/2, -u/2); moved
// (v/2, 1 - u/2). With the other sign of the sine, as in the GLSL beside the example, v would go
// from 1 to 3/2: the page contradicts itself there, and viewers follow the example.
TEST(UvTransform, GivesTheQuadrantOfTheSpecificationsExample)
{
    const UvTransform example{.offset = {0, 1}, .scale = {0.5, 0.5}, .rotation = quarter};
    expect_at(example({0, 0}), 0, 1);
    expect_at(example({1, 0}), 0, 0.5);
    expect_at(example({0, 1}), 0.5, 1);
    expect_at(example({1, 1}), 0.5, 0.5);
    // Clockwise: what is at the top of the quadrant, left to right, is seen on the right, downward.
    expect_at(example({1, 0.25}), 0.125, 0.5);
    expect_at(example({1, 0.75}), 0.375, 0.5);
}

TEST(UvTransform, InvertsVAsTheSecondExampleDoes)
{
    const UvTransform inverted{.offset = {0, 1}, .scale = {1, -1}};
    expect_at(inverted({0.3f, 0.2f}), 0.3, 0.8);
}

// Computed by hand: (0.6, 0.2) scaled by (2, 3) is (1.2, 0.6); turned by 30 degrees, cos 0.8660254
// and sin 0.5, it is (1.0392305 + 0.3, 0.5196152 - 0.6) = (1.3392305, -0.0803848); then it is
// moved.
TEST(UvTransform, ScalesThenTurnsThenMoves)
{
    const UvTransform all{.offset = {0.25, -0.5}, .scale = {2, 3}, .rotation = quarter / 3};
    expect_at(all({0.6f, 0.2f}), 1.5892305, -0.5803848);
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/box_tree.h"

#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::Noise;

TEST(BoxTree, FindsWhatASearchOfAllBoxesFinds)
{
    Noise noise;
    std::vector<Box> boxes(200);
    for (Box& b : boxes) {
        const glm::dvec3 p = 5.0 * noise.vec3();
        b.add(p);
        b.add(p + noise.vec3());
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = 6.0 * noise.vec3();
        double least = 1e300;
        std::vector<int> near;
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            least = std::min(least, boxes[b].distance(p));
            if (boxes[b].distance(p) <= 1) near.push_back(static_cast<int>(b));
        }
        EXPECT_EQ(tree.distance(p), least);
        EXPECT_EQ(tree.near(p, 1), near);
    }
    EXPECT_TRUE(BoxTree(std::vector<Box>{}).near({0, 0, 0}, 1).empty());
}

} // namespace
} // namespace trivar

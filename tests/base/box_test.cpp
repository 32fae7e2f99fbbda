// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/box.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Box, IsEmptyUntilSomethingIsAdded)
{
    Box box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.size(), glm::dvec3(0));
    box.add(glm::dvec3(1, 2, 3));
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.center(), glm::dvec3(1, 2, 3));
    EXPECT_EQ(box.size(), glm::dvec3(0));
}

TEST(Box, HoldsWhatWasAdded)
{
    Box a, b;
    a.add(glm::dvec3(0));
    a.add(glm::dvec3(2, 1, 1));
    b.add(glm::dvec3(-1, 0, 5));
    a.add(b);
    a.add(Box());
    EXPECT_EQ(a.lo, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(a.hi, glm::dvec3(2, 1, 5));
}

TEST(Box, DistanceIsToTheNearestPoint)
{
    Box box;
    box.add(glm::dvec3(0));
    box.add(glm::dvec3(1));
    EXPECT_EQ(box.distance({0.5, 0.5, 0.5}), 0);
    EXPECT_EQ(box.distance({1, 1, 1}), 0);
    EXPECT_EQ(box.distance({0.5, -2, 0.5}), 2);
    EXPECT_EQ(box.distance({4, 5, 0.5}), 5);
}

} // namespace
} // namespace trivar

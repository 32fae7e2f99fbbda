// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/morphed.h"

#include "core/mesh/primitives.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

Mesh coloured_box(const glm::dvec3& size, const glm::vec4& color)
{
    Mesh mesh = box_mesh(size, {1, 1, 1});
    mesh.colors.assign(mesh.vertex_count(), color);
    return mesh;
}

TEST(Morphed, GoesFromOneMeshToTheOther)
{
    const Mesh a = coloured_box({1, 1, 1}, {0, 0, 0, 1}), b = coloured_box({2, 4, 1}, {1, 1, 0, 1});
    ASSERT_TRUE(can_become(a, b));
    EXPECT_EQ(morphed(a, b, 0), a);
    const Mesh half = morphed(a, b, 0.5), all = morphed(a, b, 1), beyond = morphed(a, b, 2);
    for (std::size_t v = 0; v < a.vertex_count(); ++v) {
        EXPECT_LT(glm::distance(half.positions[v], (a.positions[v] + b.positions[v]) / 2.0f), 1e-6);
        EXPECT_LT(glm::distance(all.positions[v], b.positions[v]), 1e-6);
        EXPECT_NEAR(glm::length(half.normals[v]), 1, 1e-6);
    }
    EXPECT_EQ(half.colors[0], glm::vec4(0.5f, 0.5f, 0, 1));
    EXPECT_EQ(beyond.colors[0], glm::vec4(1, 1, 0, 1));
    EXPECT_EQ(all.corners, a.corners);
}

TEST(Morphed, NeedsAsManyVerticesAndCorners)
{
    const Mesh box = box_mesh({1, 1, 1}, {1, 1, 1});
    EXPECT_FALSE(can_become(box, box_mesh({1, 1, 1}, {2, 1, 1})));
    Mesh other = box;
    other.corners.pop_back();
    EXPECT_FALSE(can_become(box, other));
    EXPECT_TRUE(can_become(box, box_mesh({3, 2, 1}, {1, 1, 1})));
}

} // namespace
} // namespace trivar

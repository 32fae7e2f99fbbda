// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/extent.h"

#include "core/mesh/primitives.h"
#include "tests/support/rigged.h"

#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

constexpr double huge = 1.01 * most_coordinate;

Mesh box_with(float x)
{
    Mesh mesh = box_mesh({2, 2, 2}, {1, 1, 1});
    mesh.positions.front().x = x;
    return mesh;
}

TEST(Extent, IsTheBoxOfAMeshAsFarAsThatCanBeWorkedWith)
{
    const auto of = [](float x) { return Extent(make_ref(box_with(x))).posed(nullptr); };
    EXPECT_EQ(of(-5)->lo, glm::dvec3(-5, -1, -1));
    EXPECT_TRUE(of(static_cast<float>(-0.99 * most_coordinate)));
    EXPECT_FALSE(of(static_cast<float>(-huge)));
    EXPECT_FALSE(of(std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(of(std::numeric_limits<float>::quiet_NaN()));
    Mesh bad = box_mesh({2, 2, 2}, {1, 1, 1});
    bad.normals.at(3).y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(Extent(make_ref(bad)).posed(nullptr));
}

TEST(Extent, OfAPoseHoldsEveryVertexAndRefusesWhatGoesTooFar)
{
    const Model bar = testing::rigged_model();
    const Ref<Mesh> mesh = bar.meshes.front();
    const Extent extent(mesh);
    Pose pose{.joints = std::vector<glm::mat4>(2, glm::mat4(1)), .morph_weights = {0.5f}};
    pose.joints[1][3] = {0, 7, 0, 1};
    const std::optional<Box> box = extent.posed(&pose);
    ASSERT_TRUE(box);
    for (const glm::vec3& p : posed(*mesh, pose).positions)
        EXPECT_LT(box->distance(glm::dvec3(p)), 1e-6);
    for (const float far : {static_cast<float>(huge), std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
        Pose wild = pose;
        wild.joints[1][3].y = far;
        EXPECT_FALSE(extent.posed(&wild));
        wild = pose;
        wild.morph_weights = {1e5f * far};
        EXPECT_FALSE(extent.posed(&wild));
    }
}

TEST(Extent, DoesNotMindAJointThatIsFarOutAndMovesNothing)
{
    const Ref<Mesh> mesh = testing::rigged_model().meshes.front();
    Pose pose{.joints = std::vector<glm::mat4>(3, glm::mat4(1)), .morph_weights = {}};
    pose.joints[2] = glm::mat4(std::numeric_limits<float>::infinity());
    const std::optional<Box> box = Extent(mesh).posed(&pose);
    ASSERT_TRUE(box);
    EXPECT_EQ(box->size(), bounding_box(*mesh).size());
}

TEST(WithinReach, IsWhereEveryCornerIsAndTheMatrixIsFinite)
{
    const Box flat = bounding_box(plane_mesh({2, 2}, {1, 1}));
    glm::dmat4 matrix(1);
    EXPECT_TRUE(within_reach(flat, matrix));
    matrix[0][0] = most_coordinate;
    EXPECT_TRUE(within_reach(flat, matrix));
    matrix[0][0] = huge;
    EXPECT_FALSE(within_reach(flat, matrix));
    matrix[0][0] = 1;
    matrix[2][2] = std::numeric_limits<double>::infinity(); // by which all of it is 0 away
    EXPECT_FALSE(within_reach(flat, matrix));
    EXPECT_TRUE(within_reach(Box()));
    Model model = single_mesh_model("", plane_mesh({2, 2}, {1, 1}));
    EXPECT_FALSE(too_large(model));
    model.nodes.front().to_parent = matrix;
    EXPECT_TRUE(too_large(model));
}

} // namespace
} // namespace trivar

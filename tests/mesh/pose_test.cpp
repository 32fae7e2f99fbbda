// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/pose.h"
#include "tests/support/rigged.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::rigged_model;

Channel channel(Channel::Interpolation interpolation, std::vector<float> values)
{
    return {0, Channel::Of::translation, interpolation, {1, 2, 4}, std::move(values), 3};
}

TEST(Clip, HoldsJoinsAndCurvesBetweenKeys)
{
    const std::vector<float> keys{0, 0, 0, 8, 0, 0, 0, 4, 0};
    const Channel step = channel(Channel::Interpolation::step, keys),
                  linear = channel(Channel::Interpolation::linear, keys);
    EXPECT_EQ(value_at(step, 1.99)[0], 0);
    EXPECT_EQ(value_at(step, 2)[0], 8);
    EXPECT_EQ(value_at(linear, 1.25)[0], 2);
    EXPECT_EQ(value_at(linear, 3)[1], 2);
    for (const Channel& each : {step, linear}) { // beyond the ends as there
        EXPECT_EQ(value_at(each, -5)[0], 0);
        EXPECT_EQ(value_at(each, 9)[1], 4);
    }
    // x = t^3 - 2 t + 5 is a cubic: Hermite's form of it is it.
    const auto x = [](double t) { return t * t * t - 2 * t + 5; };
    const auto slope = [](double t) { return 3 * t * t - 2; };
    Channel cubic{0, Channel::Of::translation, Channel::Interpolation::cubic, {1, 2, 4}, {}, 3};
    for (const double t : {1.0, 2.0, 4.0})
        for (const double v : {slope(t), x(t), slope(t)})
            cubic.values.insert(cubic.values.end(), {float(v), 0, 0});
    for (const double t : {1.0, 1.3, 2.0, 2.5, 3.9})
        EXPECT_NEAR(value_at(cubic, t)[0], x(t), 1e-6) << t;
}

TEST(Clip, TurnsTheShorterWayAtConstantSpeed)
{
    // A quarter turn about z, the second key with the opposite sign, which is the same rotation.
    const float half = std::sqrt(0.5f);
    const Channel turn{0,
                       Channel::Of::rotation,
                       Channel::Interpolation::linear,
                       {0, 1},
                       {0, 0, 0, 1, 0, 0, -half, -half},
                       4};
    for (const double t : {0.25, 0.5, 0.8}) {
        const std::vector<double> q = value_at(turn, t);
        EXPECT_NEAR(2 * std::atan2(q[2], q[3]), t * glm::radians(90.0), 1e-6);
    }
    Channel nothing = turn;
    nothing.values.assign(8, 0.0f);
    EXPECT_EQ(value_at(nothing, 0.5)[3], 1);
}

TEST(Pose, WithoutAClipIsAsTheModelCame)
{
    const Model model = rigged_model();
    const Pose pose = pose_of(model, 0, stance_at(model, nullptr, 0));
    ASSERT_EQ(pose.joints.size(), 2u);
    const Mesh& rest = *model.meshes[0];
    const Mesh out = posed(rest, pose);
    for (std::size_t v = 0; v < rest.vertex_count(); ++v) {
        EXPECT_LT(glm::distance(out.positions[v], rest.positions[v]), 1e-6);
        EXPECT_LT(glm::distance(out.normals[v], rest.normals[v]), 1e-6);
    }
    EXPECT_TRUE(out.influences.empty());
    EXPECT_TRUE(out.morph_targets.empty());
    EXPECT_EQ(out.corners, rest.corners);
}

TEST(Pose, TurnsEachEndWithItsJoint)
{
    const Model model = rigged_model();
    const Pose pose = pose_of(model, 0, stance_at(model, &model.clips[0], 1));
    const Mesh& rest = *model.meshes[0];
    const Mesh out = posed(rest, pose);
    for (std::size_t v = 0; v < rest.vertex_count(); ++v) {
        const glm::vec3 p = rest.positions[v], n = rest.normals[v];
        if (p.x <= 1) {
            EXPECT_LT(glm::distance(out.positions[v], p), 1e-6);
        } else if (p.x >= 3) { // about (2, 0, 0) by a right angle about z
            EXPECT_LT(glm::distance(out.positions[v], {2 - p.y, p.x - 2, p.z}), 1e-6);
            EXPECT_LT(glm::distance(out.normals[v], {-n.y, n.x, n.z}), 1e-6);
            EXPECT_LT(glm::distance(glm::vec3(out.tangents[v]), {0, 1, 0}), 1e-6);
        }
        EXPECT_NEAR(glm::length(out.normals[v]), 1, 1e-6);
    }
}

TEST(Pose, GoesTheWholeWayToATargetAndAsFarAsItsWeight)
{
    const Model model = rigged_model();
    const Mesh& rest = *model.meshes[0];
    for (const float weight : {0.0f, 0.25f, 1.0f}) {
        const Pose pose = pose_of(model, 0, stance_at(model, &model.clips[1], double(weight)));
        EXPECT_EQ(pose.morph_weights.empty(), weight == 0);
        const Mesh out = posed(rest, pose);
        for (std::size_t v = 0; v < rest.vertex_count(); ++v) {
            const Mesh::MorphTarget& target = rest.morph_targets[0];
            EXPECT_LT(
                glm::distance(out.positions[v], rest.positions[v] + weight * target.positions[v]),
                1e-6);
            EXPECT_LT(glm::distance(out.normals[v],
                                    glm::normalize(rest.normals[v] + weight * target.normals[v])),
                      1e-6);
        }
    }
}

TEST(Pose, StaysInItsBoxAndHasTheSameBitsOnAnyNumberOfThreads)
{
    const Model model = rigged_model();
    const Mesh& rest = *model.meshes[0];
    for (const Clip& clip : model.clips)
        for (const double time : {0.2, 0.7, 1.0}) {
            const Pose pose = pose_of(model, 0, stance_at(model, &clip, time));
            const Mesh out = posed(rest, pose);
            const Box box = posed_bounds(bounding_box(rest), target_bounds(rest), pose);
            for (const glm::vec3& p : out.positions) EXPECT_LT(box.distance(glm::dvec3(p)), 1e-6);
            const ThreadLimit one(1);
            EXPECT_EQ(posed(rest, pose), out);
        }
}

TEST(Pose, TheBoxOfAModelIsThatOfWhereItStands)
{
    const Model model = rigged_model();
    const glm::dvec3 straight = bounding_box(model).size(),
                     bent = bounding_box(model, &model.clips[0], 1).size();
    EXPECT_LT(glm::distance(straight, {4, 1, 1}), 1e-6);
    EXPECT_LT(bent.x, 3);
    EXPECT_GT(bent.y, 2);
}

TEST(Pose, PutsASkinWhereItsJointsAreAndNotWhereItsNodeIs)
{
    Model model = rigged_model();
    model.nodes[0].to_parent = glm::translate(glm::dmat4(1), {100, 0, 0});
    model.nodes[1].outer = model.nodes[1].to_parent = glm::translate(glm::dmat4(1), {0, 7, 0});
    const Stance stance = stance_at(model, nullptr, 0);
    EXPECT_EQ(mesh_to_model(model, 0, stance), glm::dmat4(1));
    const Mesh out = posed(*model.meshes[0], pose_of(model, 0, stance));
    EXPECT_LT(glm::distance(out.positions[0], model.meshes[0]->positions[0] + glm::vec3(0, 7, 0)),
              1e-5);
}

} // namespace
} // namespace trivar

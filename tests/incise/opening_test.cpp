// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/opened_frames.h"
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// How wide the gap is at a place of the sphere: twice the way of the nearest wall vertex there
// that moves most.
double gap_at(const IncisedMesh& made, const Mesh& open, const glm::dvec3& place)
{
    double most = 0;
    for (const std::uint32_t v : made.moved)
        if (v >= made.first_wall_vertex &&
            glm::distance(glm::dvec3(made.rest->positions[v]), place) < 0.03)
            most =
                std::max(most, double{glm::distance(made.rest->positions[v], open.positions[v])});
    return 2 * most;
}

class OpenSphere : public ::testing::Test {
protected:
    SlitSkin skin = skin_of(sphere_mesh(1, 96, 48));
    const glm::dvec3 middle{1, 0, 0};
    const Incision along = cut_on_sphere({{1, -0.4, 0.003}, {1, 0.4, -0.002}});
};

TEST_F(OpenSphere, TheGapIsAsWideAsAskedInTheMiddleAndShutAtTheEnds)
{
    const IncisedMesh made = incise(skin, std::vector{along});
    EXPECT_EQ(made.outcomes[0].widest, 1);
    EXPECT_NEAR(made.outcomes[0].depth, 0.1, 1e-6);
    EXPECT_NEAR(made.outcomes[0].length, 2 * std::atan(0.4), 0.01);
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    EXPECT_TRUE(is_closed_body(*open));
    EXPECT_NEAR(gap_at(made, *open, middle), along.width, 0.05 * along.width);
    EXPECT_LT(gap_at(made, *open, along.stroke.front().p), 0.1 * along.width);
    const Ref<Mesh> half = opened(made, std::vector{IncisionOpening{0.5, 0, 1}});
    EXPECT_NEAR(gap_at(made, *half, middle), 0.5 * along.width, 0.03 * along.width);
}

TEST_F(OpenSphere, ACustomProfileOpensWhereItSays)
{
    Incision cut = along;
    cut.opening_profile = {IncisionProfile::Shape::custom, {{0, 0}, {0.45, 0}, {0.7, 1}, {1, 1}}};
    const IncisedMesh made = incise(skin, std::vector{cut});
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    const glm::dvec3 early = glm::normalize(glm::dvec3(1, -0.15, 0));
    const glm::dvec3 late = glm::normalize(glm::dvec3(1, 0.16, 0));
    EXPECT_EQ(gap_at(made, *open, early), 0);
    EXPECT_GT(gap_at(made, *open, late), 0.8 * cut.width);
}

TEST_F(OpenSphere, TheBladeOpensWhatItHasPassed)
{
    const IncisedMesh made = incise(skin, std::vector{along});
    const Ref<Mesh> open = opened(made, std::vector{IncisionOpening{1, 0, 0.5}});
    EXPECT_GT(gap_at(made, *open, glm::normalize(glm::dvec3(1, -0.15, 0))), 0.4 * along.width);
    EXPECT_EQ(gap_at(made, *open, glm::normalize(glm::dvec3(1, 0.15, 0))), 0);
}

TEST_F(OpenSphere, FlapsBetweenCrossingCutsMoveOutwardsTogether)
{
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere());
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(2));
    std::size_t corners = 0; // of the four flaps, at the crossing
    for (const std::uint32_t v : made.moved) {
        const glm::dvec3 rest(made.rest->positions[v]);
        if (v >= made.first_wall_vertex || glm::distance(rest, middle) > 0.02) continue;
        const glm::dvec3 move = glm::dvec3(open->positions[v]) - rest;
        corners += std::abs(move.y) > 0.03 && std::abs(move.z) > 0.03;
    }
    EXPECT_GE(corners, 4u);
    EXPECT_TRUE(is_closed_body(*open));
}

TEST_F(OpenSphere, EachOfTwoCutsOpensByItself)
{
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere());
    const Ref<Mesh> open = opened(made, std::vector{IncisionOpening{1, 0, 1}, {0, 0, 1}});
    EXPECT_TRUE(is_closed_body(*open));
    EXPECT_GT(gap_at(made, *open, middle), 0.08);
    EXPECT_EQ(gap_at(made, *open, glm::normalize(glm::dvec3(1, 0, 0.39))), 0);
}

TEST_F(OpenSphere, AUFloorHasTheShareOfTheWidthThatIsAskedFor)
{
    Incision cut = along;
    cut.floor = Incision::Floor::u;
    cut.floor_width = 0.5;
    const IncisedMesh made = incise(skin, std::vector{cut});
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    EXPECT_TRUE(is_closed_body(*open));
    double most = 0; // of the vertices of the floor
    for (const std::uint32_t v : made.moved)
        if (glm::length(made.rest->positions[v]) < 0.901f)
            most =
                std::max(most, double{glm::distance(made.rest->positions[v], open->positions[v])});
    EXPECT_NEAR(2 * most, 0.5 * cut.width, 1e-3 * cut.width);
}

TEST_F(OpenSphere, TheGuardKeepsWallsFromMeetingInAThinBody)
{
    const SlitSkin thin = skin_of(box_mesh({2, 2, 0.1}, {40, 40, 2}));
    Incision cut;
    cut.depth = 0.5;
    cut.width = 0.5;
    for (int i = 0; i <= 30; ++i) cut.stroke.push_back({{-0.6 + 0.04 * i, 0.03, 0.05}, {0, 0, 1}});
    const IncisedMesh made = incise(thin, std::vector{cut});
    EXPECT_EQ(made.outcomes[0].refusal, "");
    EXPECT_LT(made.outcomes[0].depth, 0.05);
    EXPECT_NEAR(made.outcomes[0].least_depth, made.outcomes[0].depth / cut.depth, 0.01);
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    for (std::size_t v = made.first_wall_vertex; v < open->vertex_count(); ++v)
        EXPECT_GT(open->positions[v].z, -0.05f);
}

TEST(Depths, AreLowerWhereTheBodyIsThinAndNowhereElse)
{
    Mesh wedge = box_mesh({2, 1, 1}, {40, 20, 4}); // 0.1 thick at one end and 1 at the other
    for (glm::vec3& p : wedge.positions) p.z *= 0.55f + 0.45f * p.x;
    const SlitSkin skin = skin_of(wedge);
    const auto along = [&](double from, double to) {
        Incision cut;
        cut.depth = 0.2;
        cut.width = 0.05;
        for (int i = 0; i <= 30; ++i) {
            const double x = from + (to - from) * i / 30;
            cut.stroke.push_back({{x, 0.03, 0.5 * (0.55 + 0.45 * x)}, {-0.22, 0, 0.97}});
        }
        return cut;
    };
    const std::vector cuts{along(-0.9, -0.5), along(0.2, 0.8), along(-0.8, 0.1)};
    const IncisedMesh made = incise(skin, cuts);
    EXPECT_LT(made.outcomes[0].depth, 0.17);
    EXPECT_NEAR(made.outcomes[1].depth, 0.2, 1e-6);
    EXPECT_NEAR(made.outcomes[1].least_depth, 1, 1e-9);
    EXPECT_LT(made.outcomes[2].least_depth, 0.9); // at its thin end
    EXPECT_NEAR(made.outcomes[2].depth, 0.2, 0.01);
}

TEST_F(OpenSphere, FramesAreWhatIsOpenedAndUseMemoryAgain)
{
    const Ref<IncisedMesh> made = make_ref(incise(skin, crossing_cuts_on_sphere()));
    auto frames = std::make_unique<OpenedFrames>(made);
    const auto openings = [](int i) {
        return std::vector{IncisionOpening{0.1 * i, 0, 1}, {1 - 0.1 * i, 0.02 * i, 1}};
    };
    EXPECT_EQ((*frames)(std::vector(2, IncisionOpening{0, 0, 1})).mesh, made->original);
    Ref<Mesh> held = (*frames)(openings(7)).mesh, last;
    const glm::vec3* memory = nullptr; // of the mesh before the last, which nobody holds
    const Mesh before = *held;
    for (int i = 1; i < 6; ++i) {
        const OpenedFrames::Frame frame = (*frames)(openings(i));
        EXPECT_EQ(*frame.mesh, *opened(*made, openings(i)));
        const Box box = bounding_box(*frame.mesh);
        EXPECT_EQ(frame.box.lo, box.lo);
        EXPECT_EQ(frame.box.hi, box.hi);
        EXPECT_NE(frame.mesh, last);
        if (last) memory = last->positions.data();
        last = frame.mesh;
    }
    EXPECT_EQ(*held, before);
    EXPECT_EQ((*frames)(openings(3)).mesh->positions.data(), memory);
    frames = nullptr; // meshes outlive it
    held = nullptr;
}

TEST(CutProfiles, AreShutAtBothEndsAndReachTheirGreatestValue)
{
    for (const IncisionProfile& profile :
         {IncisionProfile{}, IncisionProfile{IncisionProfile::Shape::even, {}},
          IncisionProfile{IncisionProfile::Shape::custom, {{0, 1}, {1, 1}}}}) {
        EXPECT_EQ(value_at(profile, 0), 0);
        EXPECT_EQ(value_at(profile, 1), 0);
        EXPECT_DOUBLE_EQ(value_at(profile, 0.5), 1);
    }
}

} // namespace
} // namespace trivar::testing

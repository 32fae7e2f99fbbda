// SPDX-License-Identifier: GPL-3.0-or-later
// Walls that lean, rims that are set back, and loops with a floor.
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"

#include <gtest/gtest.h>
#include <numbers>

namespace trivar::testing {
namespace {

class OnABlock : public ::testing::Test {
protected:
    SlitSkin block = skin_of(box_mesh({2, 2, 1}, {40, 40, 10}));

    static Incision along(const glm::dvec2& from, const glm::dvec2& to)
    {
        Incision cut;
        for (int i = 0; i <= 20; ++i) {
            const glm::dvec2 p = from + i / 20.0 * (to - from);
            cut.stroke.push_back({{p.x, p.y, 0.5}, {0, 0, 1}});
        }
        cut.depth = 0.2;
        cut.width = 0.08;
        return cut;
    }
    const Incision straight = along({-0.5, 0.011}, {0.5, 0.017});

    Ref<Mesh> cut_open(const std::vector<Incision>& cuts)
    {
        const IncisedMesh made = incise(block, cuts);
        for (const IncisedMesh::Outcome& each : made.outcomes) {
            EXPECT_EQ(each.refusal + each.shortfall, "");
            EXPECT_EQ(each.widest, 1);
        }
        EXPECT_TRUE(faults_of(made).none());
        EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
        const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(cuts.size()));
        EXPECT_TRUE(is_closed_body(*open));
        return open;
    }
};

// The places of vertices near the middle of the cut at a height.
std::vector<double> across_at(const Mesh& mesh, double z)
{
    std::vector<double> out;
    for (const glm::vec3& p : mesh.positions)
        if (std::abs(p.x) < 0.05 && std::abs(p.y) < 0.35 && std::abs(p.z - z) < 1e-3)
            out.push_back(p.y);
    std::ranges::sort(out);
    return out;
}

TEST_F(OnABlock, ACutThatLeansStaysWhereItIsWhenReversedAndGoesToTheOtherSideWhenMirrored)
{
    Incision cut = along({0.3, -0.4}, {0.35, 0.4});
    cut.lean_deg = 30;
    const auto floor_of = [&](const Incision& one) { // the mean of its deepest points
        const Ref<Mesh> open = cut_open({one});
        glm::dvec3 sum(0);
        double count = 0, lowest = 1;
        const std::size_t first = block.mesh()->vertex_count();
        for (std::size_t v = first; v < open->vertex_count(); ++v)
            lowest = std::min(lowest, double{open->positions[v].z});
        for (std::size_t v = first; v < open->vertex_count(); ++v)
            if (open->positions[v].z < lowest + 0.01) {
                sum += glm::dvec3(open->positions[v]);
                ++count;
            }
        return sum / count;
    };
    const glm::dvec3 here = floor_of(cut), turned = floor_of(reversed(cut)),
                     there = floor_of(mirrored(cut));
    EXPECT_LT(here.x, 0.25); // to the left of a stroke along y
    EXPECT_NEAR(turned.x, here.x, 0.01);
    EXPECT_NEAR(there.x, -here.x, 0.01);
}

TEST_F(OnABlock, ALeanTakesTheFloorToTheLeft)
{
    for (const double lean : {-30.0, 0.0, 40.0}) {
        Incision cut = straight;
        cut.lean_deg = lean;
        const Ref<Mesh> open = cut_open({cut});
        const std::vector<double> floor = across_at(*open, 0.3);
        ASSERT_FALSE(floor.empty());
        EXPECT_NEAR(floor.front(), 0.014 + 0.2 * std::tan(lean * std::numbers::pi / 180), 0.01);
    }
}

TEST_F(OnABlock, ABevelSetsTheRimBackAndLeavesTheWallBelow)
{
    Incision cut = straight;
    cut.floor = Incision::Floor::u;
    cut.floor_width = 1;
    const auto gap_at = [&](const Mesh& mesh, double z) {
        const std::vector<double> all = across_at(mesh, z);
        double left = 1, right = -1; // the nearest on both sides
        for (const double y : all) {
            if (y > 0.014) left = std::min(left, y);
            if (y < 0.014) right = std::max(right, y);
        }
        return left - right;
    };
    EXPECT_NEAR(gap_at(*cut_open({cut}), 0.5), 0.08, 0.004);
    for (const double roundness : {0.0, 1.0}) {
        cut.bevel = 0.03;
        cut.roundness = roundness;
        const Ref<Mesh> open = cut_open({cut});
        EXPECT_NEAR(gap_at(*open, 0.5), 0.08 + 2 * 0.03, 0.006);
        EXPECT_NEAR(gap_at(*open, 0.47), 0.08, 0.004);
        const double between = gap_at(*open, 0.5 - 0.25 * 0.03); // a row of a rounded bevel alone
        if (roundness > 0) {
            EXPECT_NEAR(between, 0.08 + 2 * 0.03 * (1 - std::sqrt(1 - 0.75 * 0.75)), 0.006);
        }
    }
}

TEST_F(OnABlock, LeaningCutsCross)
{
    Incision first = straight, second = along({0.02, -0.4}, {-0.01, 0.4});
    first.lean_deg = 25;
    second.lean_deg = -35;
    second.bevel = 0.02;
    cut_open({first, second});
    const std::vector cuts{first, second, along({-0.3, -0.4}, {-0.33, 0.4})}; // the last is upright
    for (const IncisedMesh::Outcome& each : incise(block, cuts).outcomes)
        EXPECT_NEAR(each.depth, 0.2, 1e-6); // nothing had to stay shallower
}

TEST_F(OnABlock, ALoopWithAFloorHasItsDepthAndWidthAllRound)
{
    Incision ring;
    for (int i = 0; i <= 40; ++i) {
        const double a = 2 * std::numbers::pi * (i % 40) / 40;
        ring.stroke.push_back({{0.4 * std::cos(a), 0.4 * std::sin(a), 0.5}, {0, 0, 1}});
    }
    ring.depth = 0.15;
    ring.width = 0.05;
    const IncisedMesh made = incise(block, std::vector{ring});
    const Ref<Mesh> open = cut_open({ring});
    for (int i = 0; i < 40; ++i) { // near every point of the ring the skin gives way by half
        const glm::dvec3 at = ring.stroke[static_cast<std::size_t>(i)].p;
        double most = 0, deepest = 1;
        for (const std::uint32_t v : made.moved) {
            const glm::dvec3 p(made.rest->positions[v]);
            if (glm::distance(glm::dvec2(p), glm::dvec2(at)) > 0.05) continue;
            most = std::max(most, glm::distance(p, glm::dvec3(open->positions[v])));
        }
        for (std::size_t v = made.first_wall_vertex; v < open->vertex_count(); ++v)
            if (const glm::dvec3 p(open->positions[v]);
                glm::distance(glm::dvec2(p), glm::dvec2(at)) < 0.05)
                deepest = std::min(deepest, p.z);
        EXPECT_NEAR(most, 0.025, 0.003) << i;
        EXPECT_NEAR(deepest, 0.35, 0.001) << i;
    }
}

TEST(LeaningCuts, StayClosedWhateverTheyAsk)
{
    for (std::size_t body = 0; body < 5; ++body) {
        const SlitSkin skin = skin_of(any_closed_primitive(body));
        for (std::size_t i = 0; i < 16; ++i) {
            SCOPED_TRACE(std::to_string(body) + " #" + std::to_string(i));
            RandomHand hand(skin, 5000 + 16 * body + i);
            std::vector<Incision> cuts = random_set(skin, hand, i % 10);
            for (Incision& each : cuts) {
                each.lean_deg = hand.number(-75, 75);
                each.bevel = skin.usual_edge() * hand.number(0, 2);
                each.roundness = hand.number();
            }
            const IncisedMesh made = incise(skin, cuts);
            EXPECT_TRUE(faults_of(made).none());
            EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
            EXPECT_EQ(copies_apart(*opened(made, std::vector<IncisionOpening>(cuts.size()))), 0u);
            EXPECT_EQ(opened(made, std::vector(cuts.size(), IncisionOpening{0, 0, 1})),
                      skin.mesh());
        }
    }
}

TEST(LeaningCuts, AngleAndBevelAreChecked)
{
    const SlitSkin ball = skin_of(icosphere(3));
    Incision cut = cut_on_sphere({{1, -0.4, 0}, {1, 0.4, 0}});
    cut.lean_deg = 80;
    EXPECT_EQ(incise(ball, std::vector{cut}).outcomes[0].refusal, "it leans too far");
    cut.lean_deg = 0;
    cut.bevel = -0.1;
    EXPECT_EQ(incise(ball, std::vector{cut}).outcomes[0].refusal, "its bevel is negative");
}

} // namespace
} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts through a body.
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"

#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace trivar::testing {
namespace {

constexpr IncisionOpening shut_cut{0, 0, 1};

Incision through(Incision cut)
{
    cut.floor = Incision::Floor::through;
    return cut;
}

// Round a direction, on the unit sphere.
Incision ring_on_sphere(const glm::dvec3& round, double radius, int sides = 36)
{
    const glm::dvec3 n = glm::normalize(round);
    const glm::dvec3 x = glm::normalize(glm::cross(n, glm::dvec3(0.3, 0.2, 1)));
    const glm::dvec3 y = glm::cross(n, x);
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= sides; ++i) {
        const double a = 2 * std::numbers::pi * (i % sides) / sides;
        points.push_back(n + radius * (std::cos(a) * x + std::sin(a) * y));
    }
    return through(cut_on_sphere(points, 0.1, 0.04));
}

Incision on_slab(const std::vector<glm::dvec2>& points, double top)
{
    Incision cut;
    for (const glm::dvec2& p : points) cut.stroke.push_back({{p.x, p.y, top}, {0, 0, 1}});
    cut.width = 0.05;
    return through(cut);
}

void expect_sound(const IncisedMesh& made, long euler)
{
    const SlitFaults faults = faults_of(made);
    EXPECT_EQ(faults.open, 0u);
    EXPECT_EQ(faults.twice, 0u);
    EXPECT_EQ(faults.pinched, 0u);
    EXPECT_EQ(faults.euler, euler);
    EXPECT_EQ(copies_apart(*made.rest), 0u);
}

const Incision slit = through(cut_on_sphere({{1, -0.3, 0.03}, {1, 0.3, -0.02}}));

class HollowBall : public ::testing::Test {
protected:
    SlitSkin skin = skin_of(shell_mesh(4, 0.8));
};

TEST_F(HollowBall, ASlitOpensBothSkinsAndIsATunnelBetweenThem)
{
    const IncisedMesh made = incise(skin, std::vector{slit});
    EXPECT_EQ(made.outcomes[0].refusal + made.outcomes[0].shortfall, "");
    EXPECT_EQ(made.outcomes[0].widest, 1);
    EXPECT_NEAR(made.outcomes[0].depth, 0.2, 0.01);
    expect_sound(made, -2); // two skins of two become one of two: a slit joins them
    EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    EXPECT_TRUE(is_closed_body(*open));
    double outer = 0, inner = 0; // of the skins, the way that they give
    for (std::size_t v = 0; v < open->vertex_count(); ++v) {
        const double way = glm::distance(open->positions[v], made.rest->positions[v]);
        const double far = glm::length(made.rest->positions[v]);
        if (far > 0.99) outer = std::max(outer, way);
        if (far < 0.81) inner = std::max(inner, way);
    }
    EXPECT_NEAR(outer, 0.5 * slit.width, 0.004);
    EXPECT_NEAR(inner, 0.5 * slit.width, 0.004);
}

TEST_F(HollowBall, ABevelSetsBothRimsBack)
{
    Incision cut = slit;
    cut.bevel = 0.02;
    const IncisedMesh made = incise(skin, std::vector{cut});
    EXPECT_EQ(made.outcomes[0].refusal + made.outcomes[0].shortfall, "");
    expect_sound(made, -2);
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    EXPECT_TRUE(is_closed_body(*open));
    double outer = 0, inner = 0, between = 0; // the way that rims and the middle give
    for (std::size_t v = 0; v < open->vertex_count(); ++v) {
        const double way = glm::distance(open->positions[v], made.rest->positions[v]);
        const double far = glm::length(made.rest->positions[v]);
        double& most = far > 0.99 ? outer : far < 0.81 ? inner : between;
        most = std::max(most, way);
    }
    EXPECT_NEAR(outer, 0.5 * cut.width + 0.02, 0.004);
    EXPECT_NEAR(inner, 0.5 * cut.width + 0.02, 0.004);
    EXPECT_NEAR(between, 0.5 * cut.width, 0.004);
}

TEST_F(HollowBall, AShutSlitIsTheOriginalItself)
{
    const IncisedMesh made = incise(skin, std::vector{slit});
    EXPECT_EQ(opened(made, std::vector{shut_cut}), skin.mesh());
    for (std::size_t v = 0; v < skin.mesh()->vertex_count(); ++v)
        ASSERT_EQ(made.rest->positions[v], skin.mesh()->positions[v]);
}

TEST_F(HollowBall, ALoopCutsOutAPieceAndBothHaveTheVolumeOfTheWhole)
{
    const IncisedMesh made = incise(skin, std::vector{ring_on_sphere({1, 0.2, 0.1}, 0.3)});
    EXPECT_EQ(made.outcomes[0].refusal + made.outcomes[0].shortfall, "");
    expect_sound(made, 0); // four of two skins; two of the ball with a hole, two of the piece
    EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
    EXPECT_EQ(volumes_of_parts(*made.rest).size(), 2u);
    EXPECT_EQ(made.outcomes[0].widest, 1);
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    EXPECT_TRUE(is_closed_body(*open));
    const std::vector<double> rest = volumes_of_parts(*made.rest), wide = volumes_of_parts(*open);
    EXPECT_LT(wide[0], 0.95 * rest[0]); // all round it there is a gap
}

TEST_F(HollowBall, APieceThatIsLeftOutLeavesAHoleOfItsVolume)
{
    Incision ring = ring_on_sphere({1, 0.2, 0.1}, 0.3);
    const std::vector<double> kept = volumes_of_parts(*incise(skin, std::vector{ring}).rest);
    ring.piece = Incision::Piece::left_out;
    const IncisedMesh made = incise(skin, std::vector{ring});
    expect_sound(made, -2);
    const std::vector<double> left = volumes_of_parts(*made.rest);
    ASSERT_EQ(left.size(), 1u);
    EXPECT_NEAR(left[0], kept[1], 1e-6);
    EXPECT_LT(left[0], std::accumulate(kept.begin(), kept.end(), 0.0) - 0.9 * kept[0]);
    EXPECT_EQ(*opened(made, std::vector{shut_cut}), *made.rest); // however shut, there is a hole
    EXPECT_TRUE(is_closed_body(*opened(made, std::vector<IncisionOpening>(1))));
}

TEST_F(HollowBall, SeveralPiecesAreLeftOutOfOneBall)
{
    std::vector<Incision> cuts{ring_on_sphere({1, 0.5, 0.3}, 0.2, 3),
                               ring_on_sphere({1, -0.5, 0.3}, 0.2, 3),
                               ring_on_sphere({1, 0, -0.4}, 0.25), slit};
    for (Incision& each : cuts) each.piece = Incision::Piece::left_out;
    cuts[3].stroke = cut_on_sphere({{-1, -0.2, 0}, {-1, 0.2, 0}}).stroke;
    cuts[3].piece = Incision::Piece::kept;
    const IncisedMesh made = incise(skin, cuts);
    for (const IncisedMesh::Outcome& each : made.outcomes)
        EXPECT_EQ(each.refusal + each.shortfall, "");
    expect_sound(made, -8);
    EXPECT_TRUE(is_closed_body(*opened(made, std::vector<IncisionOpening>(4))));
}

TEST_F(HollowBall, ACutWithAFloorCrossesASlit)
{
    const Incision across = cut_on_sphere({{1, 0.03, -0.3}, {1, -0.02, 0.3}}, 0.07, 0.05);
    const IncisedMesh made = incise(skin, std::vector{slit, across});
    for (const IncisedMesh::Outcome& each : made.outcomes)
        EXPECT_EQ(each.refusal + each.shortfall, "");
    expect_sound(made, -2);
    EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
    EXPECT_TRUE(is_closed_body(*opened(made, std::vector<IncisionOpening>(2))));
}

TEST_F(HollowBall, TwoSlitsThatCrossAreOneTunnel)
{
    const Incision across = through(cut_on_sphere({{1, 0.03, -0.3}, {1, -0.02, 0.3}}, 0.07));
    const IncisedMesh made = incise(skin, std::vector{slit, across});
    expect_sound(made, -2);
    EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
    for (const IncisedMesh::Outcome& each : made.outcomes) {
        EXPECT_EQ(each.refusal + each.shortfall, "");
        EXPECT_EQ(each.crossed_through, 1);
        EXPECT_EQ(each.widest, 1);
    }
    EXPECT_TRUE(is_closed_body(*opened(made, std::vector<IncisionOpening>(2))));
}

TEST(ThroughCuts, StayClosedWhereverTheyAreDrawn)
{
    for (std::size_t body = 0; body < 6; ++body) {
        const SlitSkin skin = skin_of(body < 5 ? any_closed_primitive(body) : shell_mesh(3, 0.7));
        long gone_through = 0;
        for (std::size_t i = 0; i < 24; ++i) {
            SCOPED_TRACE(std::to_string(body) + " #" + std::to_string(i));
            RandomHand hand(skin, 900 + 24 * body + i);
            std::vector<Incision> cuts = i % 3 ? std::vector{random_single(skin, hand, false)}
                                               : random_set(skin, hand, i % 10);
            for (std::size_t k = 0; k < cuts.size(); ++k)
                if (k == 0 || i % 2) cuts[k].floor = Incision::Floor::through;
            const IncisedMesh made = incise(skin, cuts);
            long through = 0, crossed = 0; // each crossing twice
            for (std::size_t k = 0; k < cuts.size(); ++k) {
                EXPECT_EQ(made.outcomes[k].refusal, "");
                crossed += made.outcomes[k].crossed_through;
                through +=
                    cuts[k].floor == Incision::Floor::through && made.outcomes[k].shortfall.empty();
            }
            expect_sound(made, crossed - 2 * through);
            EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
            EXPECT_EQ(opened(made, std::vector(cuts.size(), shut_cut)), skin.mesh());
            gone_through += through;
        }
        EXPECT_GT(gone_through, 4) << body;
    }
}

TEST(ThroughCuts, ASolidBallIsCutAlongParallelWays)
{
    const SlitSkin ball = skin_of(icosphere(4));
    const IncisedMesh made = incise(ball, std::vector{ring_on_sphere({1, 0.2, 0.1}, 0.2)});
    EXPECT_EQ(made.outcomes[0].shortfall, "");
    expect_sound(made, 0); // the ball becomes a torus, and a rod comes out
    EXPECT_EQ(volumes_of_parts(*made.rest).size(), 2u);
    EXPECT_LT(std::abs(faults_of(made).volume), 1e-9);
}

TEST(ThroughCuts, ALeanTurnsTheWayThrough)
{
    const SlitSkin slab = skin_of(box_mesh({2, 2, 0.2}, {30, 30, 3}));
    Incision cut = on_slab({{-0.5, 0.01}, {0.5, 0.02}}, 0.1);
    cut.lean_deg = 45;
    const IncisedMesh made = incise(slab, std::vector{cut});
    EXPECT_EQ(made.outcomes[0].shortfall, "");
    expect_sound(made, -2);
    double far = -1; // where the other side opens
    for (std::size_t v = made.first_wall_vertex; v < made.rest->vertex_count(); ++v)
        if (made.rest->positions[v].z < -0.0999f)
            far = std::max(far, double{made.rest->positions[v].y});
    EXPECT_NEAR(far, 0.2 + 0.02, 0.01);
}

TEST(ThroughCuts, SayWhyTheyHaveAFloor)
{
    const SlitSkin sheet = skin_of(plane_mesh({2, 2}, {20, 20}));
    IncisedMesh made = incise(sheet, std::vector{on_slab({{-0.4, 0}, {0.4, 0}}, 0)});
    EXPECT_EQ(made.outcomes[0].shortfall, "no surface lies opposite");
    const SlitSkin slab = skin_of(box_mesh({2, 2, 0.2}, {20, 20, 2}));
    Incision below = on_slab({{0, -0.4}, {0, 0.4}}, -0.1);
    for (SurfacePoint& each : below.stroke) each.normal = {0, 0, -1};
    below.floor = Incision::Floor::v;
    below.depth = 0.03;
    made = incise(slab, std::vector{on_slab({{-0.4, 0}, {0.4, 0}}, 0.1), below});
    EXPECT_EQ(made.outcomes[0].shortfall, "its other side crosses a cut");
    expect_sound(made, 0);
    Incision open = on_slab({{-0.4, 0}, {0.4, 0}}, 0.1);
    open.piece = Incision::Piece::left_out;
    made = incise(slab, std::vector{open});
    EXPECT_EQ(made.outcomes[0].shortfall,
              "it cuts out no piece, as it is no loop through the body");
    expect_sound(made, -2);
}

} // namespace
} // namespace trivar::testing

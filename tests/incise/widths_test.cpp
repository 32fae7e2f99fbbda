// SPDX-License-Identifier: GPL-3.0-or-later
// How far incisions open, and what gives way round them.
#include "core/base/rejected.h"
#include "core/mesh/mesh_region.h"
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"
#include "tests/incise/soundness.h"
#include "tests/incise/strokes.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

// Straight over the middle of the top of a slab of that thickness.
Incision over_a_slab(double thickness, double width)
{
    Incision out;
    out.depth = 0.4 * thickness;
    out.width = width;
    for (int i = 0; i <= 30; ++i)
        out.stroke.push_back({{-0.3 + 0.02 * i, 0.013, thickness / 2}, {0, 0, 1}});
    return out;
}

TEST(Widths, ThatAreLargerNeverOpenLess)
{
    for (std::size_t body = 0; body < 5; ++body) {
        const SlitSkin skin = skin_of(any_closed_primitive(body));
        for (std::size_t i = 0; i < 3; ++i) {
            RandomHand hand(skin, 9000 + 16 * body + i);
            std::vector<Incision> cuts{random_single(skin, hand, false)};
            if (i == 2) cuts = random_set(skin, hand, 1); // one that ends on another
            if (cuts.empty()) continue;
            double most = 0;
            for (double width = 0.25; width < 300; width *= 2.3) {
                cuts.back().width = width * skin.usual_edge();
                const double gap = incise(skin, cuts).outcomes.back().widest * cuts.back().width;
                EXPECT_GT(gap, 0.9 * most) << body << " " << i << " " << width;
                most = std::max(most, gap);
            }
            EXPECT_GT(most, 0.2 * skin.usual_edge());
        }
    }
}

TEST(Widths, BeyondAllReasonOpenAsFarAsTheLipsGoRound)
{
    const SlitSkin skin = skin_of(icosphere(5));
    Incision cut = cut_on_sphere({{1, -0.2, 0.003}, {1, 0.2, -0.002}}, 0.05, 50);
    const IncisedMesh made = incise(skin, std::vector{cut});
    EXPECT_TRUE(faults_of(made).none());
    const double gap = made.outcomes[0].widest * cut.width;
    EXPECT_GT(gap, 0.3 * made.outcomes[0].length);
    EXPECT_LT(gap, made.outcomes[0].length);
}

// To and fro over the top of a slab, in straight lines between random corners.
Incision scribble(int corners, std::uint64_t seed)
{
    constexpr int points_between = 16;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-0.7, 0.7);
    Incision out = over_a_slab(0.5, 0.3);
    out.stroke.clear();
    glm::dvec3 from(place(random), place(random), 0.25);
    for (int i = 1; i < corners; ++i) {
        const glm::dvec3 to(place(random), place(random), 0.25);
        for (int k = 0; k < points_between; ++k)
            out.stroke.push_back({glm::mix(from, to, 1.0 * k / points_between), {0, 0, 1}});
        from = to;
    }
    return out;
}

TEST(Scribbles, CostLittleMoreThanTheirFirstAttempt)
{
    const SlitSkin slab = skin_of(box_mesh({2, 2, 0.5}, {24, 24, 6}));
    for (const int corners : {6, 13, 30}) {
        int attempts = 0;
        const Progress counts = [&](double done, std::string_view) {
            EXPECT_TRUE(done >= 0 && done <= 1);
            ++attempts;
        };
        RefPool<Mesh> none;
        const IncisedMesh made = incise(slab, std::vector{scribble(corners, 5)}, {}, none, counts);
        EXPECT_TRUE(faults_of(made).none());
        EXPECT_TRUE(made.outcomes[0].refusal.empty()) << made.outcomes[0].refusal;
        EXPECT_LE(attempts, 10);
    }
}

TEST(Scribbles, EndWhereTheirProgressThrows)
{
    const SlitSkin slab = skin_of(box_mesh({2, 2, 0.5}, {24, 24, 6}));
    int attempts = 0;
    const Progress cancels = [&](double, std::string_view) {
        if (++attempts == 2) throw Cancelled();
    };
    RefPool<Mesh> none;
    EXPECT_THROW(incise(slab, std::vector{scribble(13, 5)}, {}, none, cancels), Cancelled);
    EXPECT_EQ(attempts, 2);
}

TEST(Reach, LeavesTheOtherSideOfAThinBodyWhereItIs)
{
    for (const double thickness : {0.04, 0.1, 0.25}) {
        const SlitSkin slab = skin_of(box_mesh({2, 2, thickness}, {60, 60, 3}));
        const IncisedMesh made = incise(slab, std::vector{over_a_slab(thickness, 0.2)});
        const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
        const Mesh& before = *slab.mesh();
        double top = 0, bottom = 0, up = 0;
        for (std::size_t v = 0; v < before.vertex_count(); ++v) {
            const glm::dvec3 p(before.positions[v]), move(open->positions[v] - before.positions[v]);
            if (p.z < -0.49 * thickness) bottom = std::max(bottom, glm::length(move));
            if (p.z > 0.49 * thickness) top = std::max(top, glm::length(move));
            up = std::max(up, move.z);
        }
        EXPECT_GT(top, 0.03) << thickness;
        EXPECT_LT(bottom, 1e-6) << thickness;
        EXPECT_LT(up, 0.02) << thickness; // the skin beside it stays on the slab
    }
}

TEST(Reach, KeepsTheSilhouetteOfABallThatIsCutWideOpen)
{
    const SlitSkin ball = skin_of(icosphere(5));
    const Incision cut = cut_on_sphere({{1, -0.5, 0.003}, {1, 0.5, -0.002}}, 0.15, 0.4);
    const IncisedMesh made = incise(ball, std::vector{cut});
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    for (std::size_t v = 0; v < ball.mesh()->vertex_count(); ++v) {
        EXPECT_LT(glm::length(open->positions[v]), 1.08f);
        if (ball.mesh()->positions[v].x < 0) {
            EXPECT_EQ(open->positions[v], ball.mesh()->positions[v]);
        }
    }
}

// A block whose top has a relief of bumps as large as a few of its triangles.
SlitSkin rough_block()
{
    Mesh mesh = box_mesh({2, 2, 1}, {120, 120, 6});
    for (glm::vec3& p : mesh.positions)
        if (p.z > 0.49f) p.z += 0.012f * std::sin(34 * p.x + 2 * p.y) * std::cos(29 * p.y);
    mesh.normals.clear();
    return skin_of(std::move(mesh));
}

TEST(Walls, AreSmoothUnderARoughSkin)
{
    const SlitSkin skin = rough_block();
    Incision cut;
    cut.depth = 0.15;
    cut.width = 0.08;
    for (int i = 0; i <= 60; ++i) {
        const double x = -0.6 + 0.02 * i, y = 0.1 + 0.1 * x;
        const double z = 0.5 + 0.012 * std::sin(34 * x + 2 * y) * std::cos(29 * y);
        cut.stroke.push_back({{x, y, z}, {0, 0, 1}});
    }
    const IncisedMesh made = incise(skin, std::vector{cut});
    EXPECT_TRUE(faults_of(made).none());
    EXPECT_GT(made.outcomes[0].least_depth, 0.9);
    // Facets of one wall turn little from one to the next
    const Mesh& rest = *made.rest;
    std::map<std::pair<std::uint32_t, std::uint32_t>, glm::dvec3> beside;
    double sum = 0, count = 0, most = 0;
    for (std::size_t f = made.first_wall_face; f < rest.face_count(); ++f) {
        const glm::dvec3 area = area_normal(rest, f);
        if (!(glm::length(area) > 1e-9)) continue;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = rest.point(rest.corners[3 * f + i]),
                                b = rest.point(rest.corners[3 * f + (i + 1) % 3]);
            const auto [known, fresh] = beside.emplace(std::minmax(a, b), area);
            if (fresh) continue;
            const double turn = std::acos(std::clamp(
                glm::dot(glm::normalize(known->second), glm::normalize(area)), -1.0, 1.0));
            if (turn > 2) continue; // both walls, at the bottom
            sum += turn * turn;
            count += 1;
            most = std::max(most, turn);
        }
    }
    EXPECT_LT(std::sqrt(sum / count), 0.02);
    EXPECT_LT(most, 0.2);
    double highest = -1; // of the bottom, away from the ends
    for (std::size_t v = made.first_wall_vertex; v < rest.vertex_count(); ++v)
        if (const glm::dvec3 p(rest.positions[v]); std::abs(p.x) < 0.4 && p.z < 0.38)
            highest = std::max(highest, p.z);
    EXPECT_LT(highest, 0.385); // the relief goes 0.012 up
}

} // namespace
} // namespace trivar::testing

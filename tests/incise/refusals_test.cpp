// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"
#include "tests/incise/soundness.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

std::string refusal_of(const SlitSkin& skin, const Incision& incision)
{
    const IncisedMesh made = incise(skin, std::vector{incision});
    EXPECT_EQ(made.rest, made.original);
    EXPECT_EQ(opened(made, std::vector<IncisionOpening>(1)), made.original);
    return made.outcomes[0].refusal;
}

Incision on_plane(const glm::dvec3& a, const glm::dvec3& b)
{
    Incision cut;
    for (int i = 0; i <= 10; ++i) cut.stroke.push_back({a + i / 10.0 * (b - a), {0, 0, 1}});
    return cut;
}

TEST(RefusedIncisions, SayWhatIsWrongWithTheStroke)
{
    const SlitSkin ball = skin_of(sphere_mesh(1, 48, 24));
    const Incision good = cut_on_sphere({{1, -0.4, 0}, {1, 0.4, 0}});
    Incision cut = good;
    cut.stroke.resize(1);
    EXPECT_EQ(refusal_of(ball, cut), "it has fewer than two points");
    cut = good;
    cut.stroke[3].p.x = NAN;
    EXPECT_EQ(refusal_of(ball, cut), "a point of it is not finite");
    cut = good;
    for (SurfacePoint& each : cut.stroke) each.p *= 1.5;
    EXPECT_EQ(refusal_of(ball, cut), "it leaves the surface");
    cut = good;
    cut.depth = 0;
    EXPECT_EQ(refusal_of(ball, cut), "it has no depth");
    cut = good;
    cut.width = -1;
    EXPECT_EQ(refusal_of(ball, cut), "its width is negative");
    cut = good;
    for (SurfacePoint& each : cut.stroke) each = good.stroke[4];
    EXPECT_EQ(refusal_of(ball, cut), "it is shorter than a step of the surface");
}

// The outcome of a single stroke that is cut, which is sound whatever part of it that is.
IncisedMesh::Outcome outcome_of(const SlitSkin& skin, const Incision& incision)
{
    const IncisedMesh made = incise(skin, std::vector{incision});
    EXPECT_TRUE(faults_of(made).none());
    EXPECT_NE(made.rest, made.original);
    return made.outcomes[0];
}

TEST(IncisionsInPart, EndWhereTheSurfaceDoes)
{
    const SlitSkin ball = skin_of(sphere_mesh(1, 48, 24));
    Incision cut = cut_on_sphere({{1, -0.4, 0}, {1, 0.4, 0}});
    const double whole = outcome_of(ball, cut).length;
    EXPECT_EQ(outcome_of(ball, cut).notice, "");
    cut.stroke[0].p *= 1.5;
    cut.stroke.back().p *= 0.5;
    IncisedMesh::Outcome outcome = outcome_of(ball, cut);
    EXPECT_EQ(outcome.refusal, "");
    EXPECT_EQ(outcome.notice, "it ends where the surface does");
    EXPECT_NEAR(outcome.length, whole * 10 / 12, 0.05 * whole);
    cut.stroke[4].p *= 1.5;
    outcome = outcome_of(ball, cut);
    EXPECT_EQ(outcome.notice, "it is cut in 2 parts, as the surface does not go on between them");
    EXPECT_NEAR(outcome.length, whole * 8 / 12, 0.05 * whole);
}

TEST(IncisionsInPart, EndBeforeAnOpenBorder)
{
    const SlitSkin sheet = skin_of(plane_mesh({2, 2}, {20, 20}));
    const IncisedMesh::Outcome outcome = outcome_of(sheet, on_plane({0, 0.03, 0}, {0.99, 0.03, 0}));
    EXPECT_EQ(outcome.refusal, "");
    EXPECT_EQ(outcome.notice, "it ends before an open border of the surface");
    EXPECT_GT(outcome.length, 0.75);
    EXPECT_LT(outcome.length, 0.91);
    EXPECT_EQ(refusal_of(sheet, on_plane({0, 0.97, 0}, {0.9, 0.97, 0})),
              "it touches an open border of the surface");
}

// Straight over a ring of radius 1, whose tube has the radius 0.4, and over the hole in its middle.
Incision over_a_ring()
{
    Incision cut;
    for (const double side : {-1.0, 1.0})
        for (int i = -10; i <= 10; ++i) {
            const double x = 0.03 * i;
            const glm::dvec3 normal(x / 0.4, 0, std::sqrt(0.16 - x * x) / 0.4);
            cut.stroke.push_back({glm::dvec3(side, 0.02, 0) + 0.4 * normal, normal});
        }
    cut.depth = 0.05;
    cut.width = 0.06;
    return cut;
}

TEST(IncisionsInPart, KeepWhatLiesOnEitherSideOfAGapOfAir)
{
    const SlitSkin ring = skin_of(torus_mesh(1, 0.4, {96, 48}));
    const Incision cut = over_a_ring();
    const IncisedMesh made = incise(ring, std::vector{cut});
    EXPECT_TRUE(faults_of(made).none());
    EXPECT_EQ(made.outcomes[0].notice,
              "it is cut in 2 parts, as the surface does not go on between them");
    EXPECT_EQ(made.outcomes[0].widest, 1);
    EXPECT_NEAR(made.outcomes[0].length, 2 * 2 * 0.4 * std::asin(0.75), 0.05);
    const auto gap = [&](const IncisionOpening& opening, double side) { // on top of the tube there
        const Ref<Mesh> open = opened(made, std::vector{opening});
        double most = 0;
        for (std::size_t v = 0; v < open->vertex_count(); ++v)
            if (glm::distance(glm::dvec3(made.rest->positions[v]), {side, 0.02, 0.4}) < 0.05)
                most = std::max(
                    most, 2.0 * double{glm::distance(open->positions[v], made.rest->positions[v])});
        return most;
    };
    for (const double side : {-1.0, 1.0}) EXPECT_NEAR(gap({1, 0, 1}, side), 0.06, 0.004);
    EXPECT_GT(gap({1, 0, 0.5}, -1), 0.05); // the blade has come as far as the hole
    EXPECT_EQ(gap({1, 0, 0.5}, 1), 0);
    for (std::size_t v = made.first_wall_vertex; v < made.rest->vertex_count(); ++v) {
        double away = 1;
        for (const SurfacePoint& each : cut.stroke)
            away = std::min(away, glm::distance(each.p, glm::dvec3(made.rest->positions[v])));
        EXPECT_LT(away, 0.08);
    }
}

TEST(RefusedIncisions, LieOnTwoParts)
{
    Mesh two = box_mesh({1, 1, 1}, {4, 4, 4});
    const Mesh other =
        transformed(two, glm::dmat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1.5, 0, 0, 1}));
    const auto first = static_cast<std::uint32_t>(two.vertex_count());
    two.points.clear();
    two.uvs.clear();
    two.normals.clear();
    two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
    for (std::size_t f = 0; f < other.face_count(); ++f) {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = other.face_begin[f]; c < other.face_begin[f + 1]; ++c)
            corners.push_back(first + other.corners[c]);
        add_face(two, corners);
    }
    Incision cut;
    cut.stroke = {{{0, 0, 0.5}, {0, 0, 1}}, {{1.5, 0, 0.5}, {0, 0, 1}}};
    EXPECT_EQ(refusal_of(skin_of(two), cut),
              "its points lie on parts of the surface that are not joined");
}

TEST(RefusedIncisions, RunOverFacesThatShareAnEdgeInThrees)
{
    Mesh mesh = plane_mesh({2, 2}, {20, 20});
    mesh.points = points_by_position(mesh.positions);
    std::uint32_t a = 0, b = 0; // an edge in the middle gets a fin
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (glm::distance(mesh.positions[v], glm::vec3(0)) < 0.01f) a = v;
        if (glm::distance(mesh.positions[v], glm::vec3(0.1f, 0, 0)) < 0.01f) b = v;
    }
    Mesh fin = mesh;
    fin.normals.clear();
    fin.uvs.clear();
    fin.positions.emplace_back(0, 0, 1);
    fin.points.push_back(static_cast<std::uint32_t>(point_count(mesh)));
    add_face(fin, std::array{a, b, static_cast<std::uint32_t>(fin.positions.size() - 1)});
    const IncisedMesh::Outcome outcome =
        outcome_of(skin_of(fin), on_plane({-0.6, 0.02, 0}, {0.3, 0.02, 0}));
    EXPECT_EQ(outcome.notice, "it is cut in 2 parts, as it touches faces that share an edge or a "
                              "point in more than one way");
    EXPECT_EQ(refusal_of(skin_of(fin), on_plane({-0.03, 0.02, 0}, {0.12, 0.02, 0})),
              "it touches faces that share an edge or a point in more than one way");
}

TEST(RefusedIncisions, AreLeftOutOfASetThatIsCutOtherwise)
{
    const SlitSkin ball = skin_of(sphere_mesh(1, 48, 24));
    std::vector<Incision> cuts = crossing_cuts_on_sphere();
    cuts.insert(cuts.begin() + 1, Incision{});
    const IncisedMesh made = incise(ball, cuts);
    EXPECT_EQ(made.outcomes[0].refusal, "");
    EXPECT_EQ(made.outcomes[1].refusal, "it has fewer than two points");
    EXPECT_EQ(made.outcomes[2].refusal, "");
    EXPECT_TRUE(faults_of(made).none());
    EXPECT_NE(opened(made, std::vector<IncisionOpening>(3)), made.original);
}

TEST(RefusedIncisions, NoneForAStrokeOfManySamples)
{
    const SlitSkin ball = skin_of(sphere_mesh(1, 48, 24));
    Incision cut = cut_on_sphere({{1, -0.4, 0}, {1, 0.4, 0}});
    const std::vector<SurfacePoint> few = cut.stroke;
    cut.stroke.clear();
    for (int i = 0; i < 100000; ++i) {
        const double t = i / 99999.0 * 0.8 - 0.4;
        const glm::dvec3 n = glm::normalize(glm::dvec3(1, t, 0));
        cut.stroke.push_back({n, n});
    }
    const IncisedMesh made = incise(ball, std::vector{cut});
    EXPECT_EQ(made.outcomes[0].refusal, "");
    EXPECT_TRUE(faults_of(made).none());
}

} // namespace
} // namespace trivar::testing

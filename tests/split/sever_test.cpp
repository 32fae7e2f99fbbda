// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/sever.h"

#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "tests/split/bodies.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

const glm::dmat4 as_it_is(1);

std::optional<Severed> severed(const Mesh& mesh, const PlainCut& cut,
                               const SeverOptions& options = {},
                               const glm::dmat4& to_own = as_it_is)
{
    Unsevered side;
    return sever(mesh, CutSheet(cut, to_own), options, side);
}

void expect_solid_halves(const Mesh& mesh, const Severed& made)
{
    double sum = 0;
    for (const Mesh& half : made.halves) {
        EXPECT_TRUE(is_closed_body(half));
        EXPECT_GT(volume(half), 0);
        sum += volume(half);
    }
    EXPECT_NEAR(sum, volume(mesh), 1e-6 * volume(mesh));
    EXPECT_EQ(made.fans, 0u);
    EXPECT_EQ(made.open, 0u);
}

// A stroke over [-2, 2] that goes up and down.
PlainCut wave(double eye = 0)
{
    PlainCut cut{.normal = {0, 0, 1}, .along = {1, 0, 0}, .eye = eye};
    for (int i = -8; i <= 8; ++i) cut.stroke.emplace_back(i / 4.0, 0.3 * std::sin(i / 4.0 * 2.5));
    return cut;
}

TEST(Sever, CutsRealPrimitivesByRandomPlanesIntoSolidHalves)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const std::vector<Mesh> bodies{welded(torus_mesh(1, 0.4, {40, 20})), ball({0, 0, 0}, 1, 24),
                                   welded(box_mesh({1, 1.4, 0.8}, {3, 2, 1})),
                                   welded(cylinder_mesh(0.6, 1.5, 24, 3))};
    for (const Mesh& body : bodies)
        for (int i = 0; i < 40; ++i) {
            const auto number = [&] { return uniform(random); };
            const PlainCut cut{.point = 0.3 * glm::dvec3(number(), number(), number()),
                               .normal = {number(), number(), number()}};
            if (const std::optional<Severed> made = severed(body, cut))
                expect_solid_halves(body, *made);
        }
}

TEST(Sever, SaysOnWhichSideABodyIsThatItMisses)
{
    const Mesh body = ball({0, 0, 0}, 1, 24);
    for (const bool up : {false, true}) {
        Unsevered side{.above = !up, .touched = true};
        const CutSheet sheet({.point = {0, 0, up ? -2.0 : 2.0}}, as_it_is);
        EXPECT_FALSE(sever(body, sheet, {}, side));
        EXPECT_EQ(side.above, up);
        EXPECT_FALSE(side.touched);
    }
}

TEST(Sever, KeepsTheBitsOfWhatIsNotOnTheCut)
{
    const Mesh body = ball({0, 0, 0}, 1, 24);
    const std::optional<Severed> made = severed(body, {.normal = {0.2, 0.1, 1}});
    ASSERT_TRUE(made);
    std::size_t known = 0;
    for (const glm::vec3& p : body.positions)
        known += std::ranges::count(made->halves[0].positions, p) > 0 ||
                 std::ranges::count(made->halves[1].positions, p) > 0;
    EXPECT_EQ(known, body.vertex_count());
}

TEST(Sever, FollowsAStrokeWithinTheTolerance)
{
    const Mesh body = welded(box_mesh({3, 2, 2}, {1, 1, 1})); // large triangles
    for (const double eye : {0.0, 4.0}) {
        const PlainCut cut = wave(eye);
        const CutSheet sheet(cut, as_it_is);
        const std::optional<Severed> made = severed(body, cut, {.tolerance = 2e-3});
        ASSERT_TRUE(made);
        expect_solid_halves(body, *made);
        EXPECT_LE(made->off, 2e-3);
        std::size_t on_cut = 0;
        for (const glm::vec3& p : made->halves[0].positions) {
            const double height = sheet.height(sheet.uvw(glm::dvec3(p)));
            EXPECT_LE(height, 2e-3); // nothing of the lower half is above
            on_cut += std::abs(height) <= 2e-3;
        }
        EXPECT_GT(on_cut, 100u);
    }
}

TEST(Sever, CutsThroughVerticesOfFacesThatItMeetsAtRightAngles)
{
    const Mesh body = welded(box_mesh({2, 2, 2}, {4, 4, 4}));
    for (const PlainCut& cut :
         {PlainCut{}, PlainCut{.normal = {1, 0, 0}}, PlainCut{.normal = {1, 1, 0}},
          PlainCut{.point = {0.5, 0, 0}, .normal = {0, 1, 1}},
          PlainCut{.stroke = {{-1, -0.5}, {-0.5, 0}, {0.5, 0}, {1, 0.5}}}}) {
        const std::optional<Severed> made = severed(body, cut);
        ASSERT_TRUE(made);
        expect_solid_halves(body, *made);
        EXPECT_LE(made->off, 1e-3);
    }
}

TEST(Sever, TurnsCapsOutwardsInAMirroredMesh)
{
    const Mesh body = welded(box_mesh({3, 2, 2}, {1, 1, 1}));
    const glm::dmat4 mirror(glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                            glm::dvec4(0.1, 0, 0, 1));
    for (const PlainCut& cut : {PlainCut{.normal = {1, 0.3, 0.2}}, wave(), wave(3)}) {
        const std::optional<Severed> made = severed(body, cut, {}, mirror);
        ASSERT_TRUE(made);
        expect_solid_halves(body, *made);
    }
}

TEST(Sever, ClosesABodyWithinABodyTwice)
{
    Mesh both = ball({0, 0, 0}, 0.6, 24);
    const Mesh inner = ball({0.02, 0.01, 0}, 0.3, 24);
    const auto vertices = static_cast<std::uint32_t>(both.vertex_count());
    const auto points = static_cast<std::uint32_t>(point_count(both));
    both.normals.clear();
    both.uvs.clear();
    both.positions.insert(both.positions.end(), inner.positions.begin(), inner.positions.end());
    for (const std::uint32_t p : inner.points) both.points.push_back(points + p);
    for (std::size_t f = 0; f < inner.face_count(); ++f) {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = inner.face_begin[f]; c < inner.face_begin[f + 1]; ++c)
            corners.push_back(vertices + inner.corners[c]);
        add_face(both, corners);
    }
    const auto made = severed(both, {.point = {0, 0, 0.1}, .normal = {0.1, 0.2, 1}});
    ASSERT_TRUE(made);
    double sum = 0;
    for (const Mesh& half : made->halves) {
        EXPECT_TRUE(is_closed_body(half));
        sum += volume(half);
    }
    EXPECT_NEAR(sum, volume(both), 1e-5);
}

TEST(CutSheet, GoesThroughItsPointsAndStraightOn)
{
    const PlainCut cut{.stroke = {{-1, 0}, {0, 0.5}, {1, 0.2}, {2, 0}}};
    const CutSheet sheet(cut, as_it_is);
    for (const glm::dvec2& p : cut.stroke) EXPECT_NEAR(sheet.phi({p.x, 7}), p.y, 1e-12);
    EXPECT_NEAR(sheet.phi({4, 0}) - sheet.phi({3, 0}), sheet.phi({3, 0}) - sheet.phi({2, 0}),
                1e-12);
    EXPECT_NEAR(glm::length(sheet.normal({0.4, 1})), 1, 1e-12);
}

TEST(CutSheet, SweepsItsStrokeFromTheEye)
{
    const PlainCut cut = wave(2);
    const CutSheet sheet(cut, as_it_is);
    const glm::dvec3 before(0, -2, 0); // the eye: normal x along goes away from it, along +y
    for (const double v : {-1.0, 0.2, 1.3}) {
        const glm::dvec3 on = sheet.point({v, 0});
        for (const double far : {0.5, 1.5, 3.0}) {
            const glm::dvec3 p = before + far * (on - before);
            EXPECT_NEAR(sheet.height(sheet.uvw(p)), 0, 1e-9);
        }
    }
}

TEST(CutSheet, BoundsItsBend)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    for (const double eye : {0.0, 4.0}) {
        const CutSheet sheet(wave(eye), as_it_is);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec2 a(uniform(random), uniform(random));
            const glm::dvec2 b = a + 0.2 * glm::dvec2(uniform(random), uniform(random));
            const double bend = sheet.bends({a, b, (a + b) / 2.0})[0];
            const double middle = sheet.phi((a + b) / 2.0);
            EXPECT_LE(std::abs(middle - (sheet.phi(a) + sheet.phi(b)) / 2), bend / 8 + 1e-12);
        }
    }
}

TEST(CutSheet, RefusesStrokesThatTurnBack)
{
    EXPECT_EQ(stroke_trouble({}), "");
    EXPECT_EQ(stroke_trouble({{0, 0}, {1, 0.2}}), "");
    EXPECT_NE(stroke_trouble({{0, 0}}), "");
    EXPECT_NE(stroke_trouble({{0, 0}, {1, 0.2}, {0.9, 0.4}}), "");
}

} // namespace
} // namespace trivar::testing

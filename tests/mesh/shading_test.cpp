// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/shading.h"

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"
#include "tests/mesh/edges.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace trivar;
using trivar::testing::count_edges;
using trivar::testing::volume;

namespace {

// A mesh as a scan is: the positions and faces of a sphere with seeded dents, without normals.
Mesh scan(int segments)
{
    const Mesh sphere = sphere_mesh(1, segments, segments / 2);
    Mesh mesh;
    mesh.positions.resize(point_count(sphere));
    for (std::size_t v = 0; v < sphere.vertex_count(); ++v) {
        const std::uint32_t p = sphere.points[v];
        const double dent = 0.02 * std::sin(12.9898 * p);
        mesh.positions[p] = glm::vec3(glm::dvec3(sphere.positions[v]) * (1 + dent));
    }
    for (const std::uint32_t v : sphere.corners) mesh.corners.push_back(sphere.points[v]);
    mesh.face_begin = sphere.face_begin;
    return mesh;
}

glm::dvec3 face_normal(const Mesh& mesh, std::size_t face)
{
    return glm::normalize(area_normal(mesh, face));
}

// The greatest angle in degrees between the normals of a mesh's corners and those of their faces.
double furthest_from_faces(const Mesh& mesh)
{
    double least = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            least = std::min(
                least, glm::dot(face_normal(mesh, f), glm::dvec3(mesh.normals[mesh.corners[c]])));
    return glm::degrees(std::acos(std::clamp(least, -1.0, 1.0)));
}

// The mesh's own corners, with what is at them in place of the numbers of its vertices.
std::vector<std::pair<glm::vec3, std::uint32_t>> places(const Mesh& mesh)
{
    std::vector<std::pair<glm::vec3, std::uint32_t>> out;
    for (const std::uint32_t v : mesh.corners) out.emplace_back(mesh.positions[v], mesh.point(v));
    return out;
}

std::vector<glm::vec3> corner_normals(const Mesh& mesh)
{
    std::vector<glm::vec3> out;
    for (const std::uint32_t v : mesh.corners) out.push_back(mesh.normals[v]);
    return out;
}

} // namespace

TEST(Shading, FlatGivesEachCornerTheNormalOfItsFace)
{
    const Mesh flat = shaded(scan(24), 0);
    EXPECT_LT(furthest_from_faces(flat), 0.1);
    EXPECT_NO_THROW(validate(flat, "it"));
}

TEST(Shading, SmoothGivesEachPointTheMeanOfAllItsFaces)
{
    const Mesh mesh = scan(24);
    const Mesh smooth = shaded(mesh, 180);
    EXPECT_EQ(smooth.normals, smooth_normals(mesh));
    EXPECT_EQ(smooth.positions, mesh.positions);
    EXPECT_EQ(smooth.corners, mesh.corners);
}

TEST(Shading, LeavesPlacesFacesAndPointsAsTheyAreAndWhatIsClosedClosed)
{
    const Mesh mesh = scan(24);
    for (const float angle : {0.0f, 5.0f, 35.0f, 180.0f}) {
        const Mesh now = shaded(mesh, angle);
        EXPECT_EQ(places(now), places(mesh)) << angle;
        EXPECT_EQ(now.face_begin, mesh.face_begin);
        EXPECT_EQ(count_edges(now).open, 0);
        EXPECT_EQ(volume(now), volume(mesh));
    }
}

TEST(Shading, ByAngleIsSmoothRoundACylinderAndSharpAtItsRims)
{
    const Mesh cylinder = cylinder_mesh(1, 2, 48, 2);
    const Mesh now = shaded(cylinder, 35);
    for (std::size_t f = 0; f < now.face_count(); ++f)
        for (std::uint32_t c = now.face_begin[f]; c < now.face_begin[f + 1]; ++c) {
            const std::uint32_t v = now.corners[c];
            const glm::dvec3 p(now.positions[v]), n(now.normals[v]);
            const bool cap = std::abs(face_normal(now, f).z) > 0.5;
            const glm::dvec3 expected =
                cap ? face_normal(now, f) : glm::normalize(glm::dvec3(p.x, p.y, 0));
            EXPECT_LT(glm::distance(n, expected), 1e-3);
        }
}

TEST(Shading, ByAngleSplitsAnEdgeFromTheAngleAt)
{
    for (const double fold_deg : {20.0, 34.5, 35.5, 90.0, 170.0}) {
        const double a = glm::radians(fold_deg);
        Mesh roof;
        roof.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0.5f, 0}, {std::cos(a), 0.5, -std::sin(a)}};
        add_face(roof, std::array{0u, 1u, 2u});
        add_face(roof, std::array{0u, 3u, 1u});
        EXPECT_EQ(shaded(roof, 35).vertex_count(), fold_deg > 35 ? 6u : 4u) << fold_deg;
    }
}

TEST(Shading, OfFacesThatAreThereTwiceIsThatOfFacesThatAreThereOnce)
{
    const Mesh mesh = scan(64);
    Mesh doubled = mesh;
    for (std::size_t f = 0; f < mesh.face_count(); f += 2)
        add_face(doubled,
                 std::span(mesh.corners)
                     .subspan(mesh.face_begin[f], mesh.face_begin[f + 1] - mesh.face_begin[f]));
    EXPECT_EQ(shaded(mesh, 120).vertex_count(), mesh.vertex_count());
    EXPECT_EQ(shaded(doubled, 120).vertex_count(), mesh.vertex_count());
}

TEST(Shading, KeepsGivenNormalsAndMakesOnlyThoseThatAreMissing)
{
    Mesh box = box_mesh({1, 1, 1}, {1, 1, 1});
    const Mesh given = box;
    for (std::size_t v = 0; v < box.normals.size(); ++v)
        if (v % 2 == 0)
            box.normals[v] = glm::vec3(0);
        else
            box.normals[v] = {0, 3, 4};
    const Mesh now = with_normals_of_faces(box, 0);
    ASSERT_EQ(now.vertex_count(), given.vertex_count());
    for (std::size_t v = 0; v < now.normals.size(); ++v)
        EXPECT_LT(
            glm::distance(now.normals[v], v % 2 == 0 ? given.normals[v] : glm::vec3(0, .6, .8)),
            1e-6);
}

TEST(Shading, TakesFacesOfOneSmoothingGroupTogetherWhateverTheirAngle)
{
    const Mesh mesh = scan(8);
    const auto by_groups = [&](const std::vector<std::uint32_t>& groups) {
        return with_normals_of_faces(mesh, 35, groups);
    };
    EXPECT_EQ(by_groups(std::vector<std::uint32_t>(mesh.face_count(), 1)), shaded(mesh, 180));
    EXPECT_LT(furthest_from_faces(by_groups(std::vector<std::uint32_t>(mesh.face_count(), 0))),
              0.1);
    // Two groups: the faces of one never turn the normals of the other.
    std::vector<std::uint32_t> two;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) two.push_back(f % 2 ? 7 : 2);
    const Mesh now = by_groups(two);
    for (std::size_t f = 0; f < now.face_count(); ++f)
        for (std::uint32_t c = now.face_begin[f]; c < now.face_begin[f + 1]; ++c)
            for (std::size_t g = f % 2 ? 0 : 1; g < now.face_count(); g += 2)
                for (std::uint32_t d = now.face_begin[g]; d < now.face_begin[g + 1]; ++d)
                    EXPECT_NE(now.corners[c], now.corners[d]);
}

TEST(Shading, IsKnownAgainWhereItFollowsFromTheFaces)
{
    const Mesh mesh = scan(24);
    EXPECT_EQ(shading_of(shaded(mesh, 0)), 0.0f);
    EXPECT_EQ(shading_of(shaded(cylinder_mesh(1, 2, 48, 2), 35)), 35.0f);
    EXPECT_EQ(shading_of(shaded(mesh, 180)), std::nullopt);
    EXPECT_EQ(shading_of(shaded(mesh, 5)), std::nullopt);
    EXPECT_EQ(shading_of(mesh), std::nullopt);
    Mesh box = box_mesh({1, 1, 1}, {1, 1, 1});
    box.normals[3] = {0, 0.6f, 0.8f};
    EXPECT_EQ(shading_of(box), std::nullopt);
}

TEST(Shading, OfAScanInFacetsLooksSmooth)
{
    const Mesh mesh = sphere_mesh(1, 200, 100);
    EXPECT_TRUE(looks_smooth(shaded(mesh, 0)));
    EXPECT_FALSE(looks_smooth(shaded(mesh, 180)));
    EXPECT_FALSE(
        looks_smooth(shaded(sphere_mesh(1, 16, 8), 0))); // has few faces, each of which is seen
    EXPECT_FALSE(looks_smooth(shaded(box_mesh({1, 1, 1}, {40, 40, 40}), 0)));
}

TEST(Shading, AnewForgetsHowItWasShadedBefore)
{
    const Mesh mesh = scan(16);
    for (const float angle : {0.0f, 20.0f, 180.0f})
        for (const float before : {0.0f, 20.0f, 180.0f})
            EXPECT_EQ(corner_normals(shaded(shaded(mesh, before), angle)),
                      corner_normals(shaded(mesh, angle)))
                << before << " " << angle;
}

TEST(Shading, IsTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = scan(200);
    const Mesh many = shaded(mesh, 3);
    const ThreadLimit one(1);
    EXPECT_EQ(shaded(mesh, 3), many);
}

TEST(Shading, EndsForAPoleOfManyFacesAndForNumbersWithoutSense)
{
    Mesh cone;
    const std::uint32_t sides = 50000;
    cone.positions.emplace_back(0, 0, 1);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double a = 2 * std::numbers::pi * i / sides;
        cone.positions.emplace_back(std::cos(a), std::sin(a), 0);
    }
    for (std::uint32_t i = 0; i < sides; ++i)
        add_face(cone, std::array{0u, 1 + i, 1 + (i + 1) % sides});
    EXPECT_NO_THROW(validate(shaded(cone, 0), "the cone"));
    Mesh odd;
    odd.positions = {{3e38f, 0, 0}, {0, 3e38f, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    add_face(odd, std::array{0u, 1u, 2u});
    add_face(odd, std::array{2u, 3u, 4u});
    add_face(odd, std::array{1u, 0u, 2u});
    add_face(odd, std::array{1u, 0u, 4u});
    for (const float angle : {0.0f, 35.0f, 180.0f})
        EXPECT_NO_THROW(validate(shaded(odd, angle), "the odd one"));
}

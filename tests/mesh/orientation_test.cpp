// SPDX-License-Identifier: GPL-3.0-or-later
// Which side of a mesh is outside.
#include "core/mesh/outside.h"
#include "core/mesh/primitives.h"
#include "core/mesh/repair.h"
#include "tests/mesh/edges.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

using testing::volume;

// Without normals, which repairs turn too.
Mesh ball(double radius, const glm::dvec3& at = glm::dvec3(0))
{
    Mesh mesh = transformed(sphere_mesh(radius, 24, 12), glm::translate(glm::dmat4(1), at));
    mesh.points = points_by_position(mesh.positions);
    return mesh;
}

void turn(Mesh& mesh, std::size_t face)
{
    std::reverse(mesh.corners.begin() + mesh.face_begin[face] + 1,
                 mesh.corners.begin() + mesh.face_begin[face + 1]);
}

Mesh turned(Mesh mesh)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f) turn(mesh, f);
    for (glm::vec3& n : mesh.normals) n = -n;
    return mesh;
}

Mesh together(const std::vector<Mesh>& meshes)
{
    Mesh out;
    for (const Mesh& mesh : meshes) {
        const auto first = static_cast<std::uint32_t>(out.vertex_count());
        out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
        out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            std::vector<std::uint32_t> face(mesh.corners.begin() + mesh.face_begin[f],
                                            mesh.corners.begin() + mesh.face_begin[f + 1]);
            for (std::uint32_t& v : face) v += first;
            add_face(out, face);
        }
    }
    out.points = points_by_position(out.positions);
    return out;
}

bool normals_look_as_faces(const Mesh& mesh)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            if (glm::dot(area_normal(mesh, f), glm::dvec3(mesh.normals[mesh.corners[c]])) <= 0)
                return false;
    return true;
}

} // namespace

TEST(Orientation, TurnsAClosedPartThatIsInsideOutWithItsNormals)
{
    const RepairedMesh out = repaired(turned(ball(1)));
    EXPECT_NEAR(volume(out.mesh), volume(ball(1)), 1e-6);
    EXPECT_EQ(out.repairs.inside_out, 1u);
    EXPECT_EQ(out.repairs.turned, 0u);
    EXPECT_TRUE(normals_look_as_faces(out.mesh));
    EXPECT_EQ(sentences(out.repairs).front(), "1 closed part was inside out and was turned");
}

TEST(Orientation, OfAWholeFileIsThatOfItsParts)
{
    std::vector<Mesh> balls;
    double expected = 0;
    for (int i = 0; i < 6; ++i) {
        balls.push_back(ball(0.5 + 0.05 * i, {2.5 * i, 0, 0}));
        expected += volume(balls.back());
        if (i % 2 == 0) balls.back() = turned(balls.back());
    }
    const RepairedMesh out = repaired(together(balls));
    EXPECT_NEAR(volume(out.mesh), expected, 1e-5);
    EXPECT_EQ(out.repairs.inside_out, 3u);
}

TEST(Orientation, OfACavityStaysAsItIs)
{
    const Mesh hollow = together({ball(2), turned(ball(1)), turned(ball(0.01, {1.5, 0, 0}))});
    const RepairedMesh out = repaired(hollow);
    EXPECT_EQ(out.repairs.inside_out, 0u);
    EXPECT_EQ(out.mesh, hollow);
}

// Within the box of the ring and not within the ring; one so small that no picture of all shows it.
TEST(Orientation, OfAPartBesideAnotherOneIsMendedWithinTheBoxOfThat)
{
    for (const double radius : {0.3, 1e-4}) {
        const Mesh ring = torus_mesh(1, 0.25, {48, 24});
        const RepairedMesh out = repaired(together({ring, turned(ball(radius))}));
        EXPECT_EQ(out.repairs.inside_out, 1u) << radius;
        EXPECT_GT(volume(out.mesh), volume(ring));
    }
}

TEST(Orientation, OfOpenSheetsThatAgreeIsLeftToTheFile)
{
    Mesh sheet = plane_mesh({2, 2}, {8, 8});
    sheet.points = points_by_position(sheet.positions);
    for (const Mesh& mesh : {sheet, turned(sheet)}) EXPECT_EQ(repaired(mesh).mesh, mesh);
}

// A car has many open parts; most of their faces may be turned, and many lie under others.
TEST(Orientation, IsVotedByWhatIsSeenFromOutside)
{
    std::mt19937 random(1);
    for (const double wrong : {0.1, 0.5, 0.8}) {
        std::vector<Mesh> panels;
        const std::vector<glm::dvec3> ways{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
        for (const glm::dvec3& way : ways) {
            Mesh panel = plane_mesh({1.9, 1.9}, {6, 6}); // with gaps between them
            const glm::dvec3 side =
                std::abs(way.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
            const glm::dmat4 there(glm::dvec4(side, 0), glm::dvec4(glm::cross(way, side), 0),
                                   glm::dvec4(way, 0), glm::dvec4(way, 1));
            panel = transformed(panel, there);
            panel.normals.clear();
            panels.push_back(panel);
            for (std::size_t f = 0; f < panel.face_count(); ++f)
                if (std::bernoulli_distribution(wrong)(random)) turn(panels.back(), f);
        }
        Mesh car = together(panels);
        const RepairedMesh out = repaired(car);
        EXPECT_GT(out.repairs.turned, 0u);
        for (std::size_t f = 0; f < out.mesh.face_count(); ++f) {
            const glm::dvec3 at(out.mesh.positions[out.mesh.corners[out.mesh.face_begin[f]]]);
            EXPECT_GT(glm::dot(at, area_normal(out.mesh, f)), 0) << wrong;
        }
    }
}

TEST(Orientation, OfAMoebiusBandIsLeftAlone)
{
    Mesh band = moebius_mesh(1, 0.4, {64, 4});
    band.points = points_by_position(band.positions);
    EXPECT_EQ(repaired(band).mesh, band);
}

TEST(Orientation, IsTheSameWhenItIsMendedAgain)
{
    Mesh mesh = together({ball(2), turned(ball(1)), turned(ball(0.4, {4, 0, 0}))});
    for (std::size_t f = 0; f < 40; ++f) turn(mesh, 7 * f);
    const Mesh once = repaired(mesh).mesh;
    EXPECT_EQ(repaired(once).mesh, once);
}

TEST(Outside, ShowsEachSideOfASheetHalfOfTheTime)
{
    Mesh sheet = plane_mesh({2, 1}, {3, 3});
    const std::vector<SeenSides> seen = seen_from_outside(
        sheet, std::vector<std::uint32_t>(sheet.face_count(), 0), 1, bounding_box(sheet));
    EXPECT_GT(seen[0].front, 1000u);
    EXPECT_NEAR(double(seen[0].back) / double(seen[0].front), 1, 0.02);
}

TEST(Outside, ShowsNothingOfWhatIsInAClosedBody)
{
    const Mesh both = together({ball(2), ball(1.9)});
    std::vector<std::uint32_t> part(both.face_count(), 0);
    std::fill(part.begin() + static_cast<std::ptrdiff_t>(ball(2).face_count()), part.end(), 1);
    const std::vector<SeenSides> seen = seen_from_outside(both, part, 2, bounding_box(both));
    EXPECT_GT(seen[0].front, 1000u);
    EXPECT_EQ(seen[0].back, 0u);
    EXPECT_EQ(seen[1].front + seen[1].back, 0u);
}

} // namespace trivar

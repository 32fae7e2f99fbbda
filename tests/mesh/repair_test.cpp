// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include "core/mesh/primitives.h"
#include "tests/mesh/edges.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace trivar {
namespace {

Mesh of_faces(const std::vector<std::vector<std::uint32_t>>& faces)
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const auto& face : faces) add_face(mesh, face);
    return mesh;
}

TEST(Repair, LeavesOutFacesThatGoToAndFroBetweenTwoPoints)
{
    EXPECT_EQ(repaired(of_faces({{0, 1, 0, 1}, {0, 1, 2}})).mesh.face_count(), 1u);
    EXPECT_EQ(repaired(of_faces({{2, 3, 2, 3, 2, 3}, {0, 1, 2, 3}})).mesh.face_count(), 1u);
}

TEST(Repair, KeepsFacesThatComeBackToAPointOnTheirWay)
{
    EXPECT_EQ(repaired(of_faces({{0, 1, 0, 2}})).mesh.face_count(), 1u);
    EXPECT_EQ(repaired(of_faces({{0, 1, 2, 1, 3}})).mesh.face_count(), 1u);
}

TEST(Repair, CountsTwoVerticesOfOnePointOnce)
{
    Mesh mesh = of_faces({{0, 1, 2, 3}, {0, 1, 2}});
    mesh.points = {0, 1, 0, 1}; // the second face comes back, the first goes to and fro
    EXPECT_EQ(repaired(std::move(mesh)).mesh.face_count(), 0u);
}

// A box whose sides each have corners of their own, near those of the others.
Mesh loose_box(float size, float off)
{
    Mesh mesh;
    const Mesh box = box_mesh(glm::dvec3(size), glm::ivec3(2));
    for (std::size_t f = 0; f < box.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t c = box.face_begin[f]; c < box.face_begin[f + 1]; ++c) {
            face.push_back(static_cast<std::uint32_t>(mesh.vertex_count()));
            mesh.positions.push_back(box.positions[box.corners[c]] +
                                     glm::vec3(float(f % 3) * off, 0, 0));
        }
        add_face(mesh, face);
    }
    return mesh;
}

TEST(Repair, JoinsBordersThatLieAFewUnitsInTheLastPlaceApart)
{
    for (const float size : {1e-6f, 1.0f, 3e7f}) {
        const RepairedMesh same = repaired(loose_box(size, 0)),
                           near = repaired(loose_box(size, 0x1p-25f * size)),
                           apart = repaired(loose_box(size, 1e-5f * size));
        EXPECT_EQ(testing::count_edges(same.mesh).open, 0);
        EXPECT_EQ(testing::count_edges(near.mesh).open, 0);
        // Vertices of one point are at one place, to the bit.
        EXPECT_EQ(points_by_position(near.mesh.positions), near.mesh.points);
        EXPECT_GT(testing::count_edges(apart.mesh).open, 0) << "a gap that somebody wants";
    }
}

TEST(Repair, JoinsASeamWhoseAnglesWereRounded)
{
    Mesh mesh = loose_box(1, 0);
    for (glm::vec3& p : mesh.positions)
        if (p.x == 0) p.x = p.y > 0 ? 6e-17f : -1e-17f;
    EXPECT_EQ(testing::count_edges(repaired(std::move(mesh)).mesh).open, 0);
}

TEST(Repair, KeepsAFaceThatIsNarrowerThanCornersAreApartByRounding)
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {4e9f, 0, 0}, {4e9f, 1, 0}, {0, 1, 0}};
    add_face(mesh, std::vector<std::uint32_t>{0, 1, 2, 3});
    const RepairedMesh repaired = trivar::repaired(mesh);
    EXPECT_EQ(repaired.mesh.face_count(), 1u);
    EXPECT_EQ(repaired.mesh.positions, mesh.positions);
}

TEST(Repair, LeavesBodiesThatTouchApart)
{
    Mesh two = box_mesh(glm::dvec3(1), glm::ivec3(1));
    two.points = points_by_position(two.positions);
    const Mesh one = two;
    for (std::size_t v = 0; v < one.vertex_count(); ++v) {
        two.positions.push_back(one.positions[v] + glm::vec3(1, 0, 0));
        two.points.push_back(one.points[v] + 8);
    }
    for (const std::uint32_t v : one.corners)
        two.corners.push_back(v + static_cast<std::uint32_t>(one.vertex_count()));
    for (std::size_t f = 1; f <= one.face_count(); ++f)
        two.face_begin.push_back(static_cast<std::uint32_t>(one.corners.size()) +
                                 one.face_begin[f]);
    two.normals.clear();
    EXPECT_EQ(repaired(two).mesh, two);
}

TEST(Repair, LeavesOutFacesThatLieOnOthersWithTheSameCorners)
{
    Mesh ball = sphere_mesh(1, 24, 12);
    ball.normals.clear();
    ball.uvs.clear();
    ball.points = points_by_position(ball.positions);
    Mesh doubled = ball;
    for (std::size_t f = 0; f < 50; ++f) { // beginning at other corners
        std::vector<std::uint32_t> face(ball.corners.begin() + ball.face_begin[f],
                                        ball.corners.begin() + ball.face_begin[f + 1]);
        std::rotate(face.begin(), face.begin() + 1, face.end());
        add_face(doubled, face);
    }
    const RepairedMesh out = repaired(doubled);
    EXPECT_EQ(out.mesh, ball);
    EXPECT_EQ(out.repairs.doubled, 50u);
    EXPECT_EQ(sentences(out.repairs).front(),
              "50 faces lay on others with the same corners and were left out");
}

TEST(Repair, LeavesOutTheSecondOfTwoBodiesAtOnePlace)
{
    Mesh twice = loose_box(1, 0);
    const Mesh once = twice;
    twice.positions.insert(twice.positions.end(), once.positions.begin(), once.positions.end());
    for (std::size_t f = 0; f < once.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t c = once.face_begin[f]; c < once.face_begin[f + 1]; ++c)
            face.push_back(once.corners[c] + static_cast<std::uint32_t>(once.vertex_count()));
        add_face(twice, face);
    }
    twice.points.resize(twice.vertex_count());
    std::iota(twice.points.begin(), twice.points.end(), 0u);
    const RepairedMesh out = repaired(std::move(twice));
    EXPECT_EQ(out.repairs.doubled, once.face_count());
    EXPECT_EQ(testing::count_edges(out.mesh).open, 0);
}

TEST(Repair, KeepsTheTwoSidesOfASheetAndFacesOfAnotherMaterial)
{
    Mesh sheet = of_faces({{0, 1, 2}, {0, 2, 1}, {0, 1, 2}});
    sheet.face_material = {0, 0, 1};
    EXPECT_EQ(repaired(std::move(sheet)).mesh.face_count(), 3u);
}

// A wheel of many faces round one edge, as a file that is made to be slow may have.
TEST(Repair, OfAnEdgeWithManyFacesTakesNoTimeByTheirSquare)
{
    Mesh wheel;
    wheel.positions = {{0, 0, 0}, {0, 0, 1}};
    for (std::uint32_t i = 0; i < 200000; ++i) {
        wheel.positions.emplace_back(std::cos(1e-3 * i) * (1 + 1e-3 * i), std::sin(1e-3 * i), 0.5);
        add_face(wheel, std::array{0u, 1u, i + 2});
    }
    EXPECT_EQ(repaired(std::move(wheel)).mesh.face_count(), 200000u);
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace trivar

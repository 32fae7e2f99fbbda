// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"

#include "core/base/rejected.h"
#include "core/mesh/teapot_patches.h"
#include "tests/mesh/edges.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace trivar;
using trivar::testing::count_edges;
using trivar::testing::EdgeCount;
using trivar::testing::real_data_folder;
using trivar::testing::volume;

namespace {

void expect_normals_along_faces(const Mesh& mesh)
{
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const glm::dvec3 n = area_normal(mesh, f);
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const glm::vec3 normal = mesh.normals[mesh.corners[c]];
            EXPECT_NEAR(glm::length(normal), 1, 1e-5) << "face " << f;
            EXPECT_GT(glm::dot(n, glm::dvec3(normal)), 0) << "face " << f;
        }
    }
}

struct Closed {
    const char* name;
    Mesh mesh;
    int euler;
    double volume, tolerance;
};

std::vector<Closed> closed_shapes()
{
    const double pi = std::numbers::pi;
    return {{"box", box_mesh({1, 2, 3}, {2, 3, 4}), 2, 6, 1e-5},
            {"sphere", sphere_mesh(1, 96, 48), 2, 4 * pi / 3, 0.02},
            {"cylinder", cylinder_mesh(0.1, 2, 97, 3), 2, 0.02 * pi, 1e-4},
            {"torus", torus_mesh(2, 0.5, {128, 64}), 0, 2 * pi * pi * 2 * 0.25, 0.03}};
}

using Patch = std::array<glm::vec3, 16>;
Patch patch_points(std::size_t patch)
{
    Patch points;
    for (std::size_t k = 0; k < 16; ++k) points[k] = teapot_points[teapot_patches[patch][k]];
    return points;
}

} // namespace

TEST(Primitives, AreClosedAndConsistentWhereTheShapeIs)
{
    for (const auto& [name, mesh, euler, expected, tolerance] : closed_shapes()) {
        SCOPED_TRACE(name);
        const EdgeCount edges = count_edges(mesh);
        EXPECT_EQ(edges.open, 0);
        EXPECT_EQ(edges.against, 0);
        EXPECT_EQ(edges.crowded, 0);
        EXPECT_EQ(edges.points - edges.edges + static_cast<int>(mesh.face_count()), euler);
    }
}

TEST(Primitives, EncloseTheVolumeOfTheShape)
{
    for (const auto& [name, mesh, euler, expected, tolerance] : closed_shapes())
        EXPECT_NEAR(volume(mesh), expected, tolerance) << name;
}

TEST(Primitives, HaveNormalsThatPointOut)
{
    for (const Closed& shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        expect_normals_along_faces(shape.mesh);
    }
    expect_normals_along_faces(plane_mesh({2, 1}, {3, 4}));
    expect_normals_along_faces(moebius_mesh(1, 0.5, {40, 4}));
}

TEST(Primitives, KeepTextureCoordinatesInTheUnitSquare)
{
    for (const Closed& shape : closed_shapes())
        for (const glm::vec2& uv : shape.mesh.uvs.at(0)) {
            EXPECT_GE(std::min(uv.x, uv.y), 0) << shape.name;
            EXPECT_LE(std::max(uv.x, uv.y), 1) << shape.name;
        }
}

TEST(Primitives, RefuseSizesAndCountsThatAreOutOfRange)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(plane_mesh({0, 1}, {1, 1}), Rejected);
    EXPECT_THROW(plane_mesh({1, 1}, {1, 2001}), Rejected);
    EXPECT_THROW(box_mesh({1, nan, 1}, {1, 1, 1}), Rejected);
    EXPECT_THROW(box_mesh({1, 1, 1}, {1, 0, 1}), Rejected);
    EXPECT_THROW(sphere_mesh(-1, 8, 4), Rejected);
    EXPECT_THROW(sphere_mesh(1, 2, 4), Rejected);
    EXPECT_THROW(cylinder_mesh(1, std::numeric_limits<double>::infinity(), 8, 1), Rejected);
    EXPECT_THROW(torus_mesh(1, 2, {8, 8}), Rejected);
    EXPECT_THROW(moebius_mesh(1, 2, {8, 8}), Rejected);
    EXPECT_THROW(teapot_mesh(1, 65), Rejected);
    EXPECT_THROW(teapot_mesh(nan, 4), Rejected);
}

TEST(Moebius, HasOneRimAndOneSide)
{
    const Mesh band = moebius_mesh(1, 0.4, {30, 4});
    const EdgeCount edges = count_edges(band);
    EXPECT_EQ(edges.open, 60);   // once round is both rims
    EXPECT_EQ(edges.against, 4); // no direction fits where the band comes back turned over
    EXPECT_EQ(edges.points - edges.edges + static_cast<int>(band.face_count()), 0);
}

TEST(Moebius, IsEquallyWideEverywhere)
{
    const Mesh band = moebius_mesh(1, 0.4, {30, 1});
    for (std::size_t v = 0; v + 1 < band.vertex_count(); v += 2)
        EXPECT_NEAR(glm::distance(band.positions[v], band.positions[v + 1]), 0.4, 1e-6);
}

TEST(Teapot, StandsOnTheGroundAtTheHeightAskedFor)
{
    const Box box = bounding_box(teapot_mesh(2, 8));
    EXPECT_NEAR(box.lo.z, 0, 1e-7);
    EXPECT_NEAR(box.hi.z, 2, 1e-6);
}

TEST(Teapot, HasNormalsThatFollowItsFaces)
{
    const Mesh teapot = teapot_mesh(1, 8);
    expect_normals_along_faces(teapot);
    for (std::size_t v = 0; v < teapot.vertex_count(); ++v)
        if (teapot.positions[v].z == 0) {
            EXPECT_LT(teapot.normals[v].z, 0);
        }
}

// Newell left sixteen sides free: the rim, the lid's edge, and the ends of handle and spout that
// stick in the body or pour. Every other side, the bottom's included, meets a neighbour.
TEST(Teapot, PatchesJoinAlongEverySideButSixteen)
{
    for (const int n : {2, 5, 8}) { // 1 would fold the round ends of handle and spout flat
        const EdgeCount edges = count_edges(teapot_mesh(1, n));
        EXPECT_EQ(edges.open, 16 * n);
        EXPECT_EQ(edges.crowded, 0);
        EXPECT_EQ(edges.against, 0);
    }
}

TEST(Teapot, BottomPatchesShareTheBodysTangentAlongTheirSeam)
{
    // The bottom's first step in from the seam continues the body's last: straight down.
    for (std::size_t bottom = 28; bottom < 32; ++bottom) {
        const Patch p = patch_points(bottom);
        for (std::size_t k = 12; k < 16; ++k) {
            EXPECT_EQ(p[k].x, p[k - 4].x);
            EXPECT_EQ(p[k].y, p[k - 4].y);
            EXPECT_GT(p[k].z, p[k - 4].z);
        }
    }
}

// geomview's copy of the patches is rounded to its own unit: x = 0.5 + X / 4, z to 1 / 2048.
TEST(RealDataTeapot, PatchesAreThoseOfAnIndependentCopy)
{
    const std::string folder = real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    std::ifstream file(folder + "/cages/teapot.bez");
    std::string header;
    ASSERT_TRUE(file >> header);
    glm::dvec3 p;
    std::size_t count = 0;
    for (; file >> p.x >> p.y >> p.z; ++count) {
        ASSERT_LT(count, 28 * 16u);
        const glm::dvec3 ours(teapot_points[teapot_patches[count / 16][count % 16]]);
        EXPECT_NEAR(p.x, 0.5 + ours.x / 4, 1e-5);
        EXPECT_NEAR(p.y, ours.y / 4, 1e-5);
        EXPECT_NEAR(p.z, 0.2625 + ours.z / 4, 6e-4);
    }
    EXPECT_EQ(count, 28 * 16u);
}

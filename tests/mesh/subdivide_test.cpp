// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/subdivide.h"

#include "core/base/rejected.h"
#include "core/mesh/primitives.h"
#include "tests/mesh/edges.h"

#include <gtest/gtest.h>

using namespace trivar;
using trivar::testing::count_edges;
using trivar::testing::EdgeCount;
using trivar::testing::volume;

namespace {

Mesh cube()
{
    Mesh mesh = box_mesh({2, 2, 2}, {1, 1, 1});
    mesh.normals.clear();
    return mesh;
}

std::uint32_t vertex_at(const Mesh& mesh, const glm::vec3& p)
{
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.positions[v] == p) return v;
    return ~0u;
}

float farthest(const Mesh& mesh)
{
    float most = 0;
    for (const glm::vec3& p : mesh.positions) most = std::max(most, glm::length(p));
    return most;
}

} // namespace

TEST(Subdivide, MakesAQuadOfEveryCornerAndFourOfEveryQuad)
{
    EXPECT_EQ(subdivide(cube(), 0), cube());
    EXPECT_EQ(subdivide(cube(), 1).face_count(), 24u);
    const Mesh mesh = subdivide(cube(), 3);
    EXPECT_EQ(mesh.face_count(), 24 * 16u);
    EXPECT_NO_THROW(validate(mesh, "mesh"));
    const EdgeCount edges = count_edges(mesh);
    EXPECT_EQ(edges.open + edges.against + edges.crowded, 0);
}

// The limit of a corner of valence 3: 3 / 8 of it, 1 / 6 of each edge neighbour and 1 / 24 of each
// face's opposite corner (Halstead, Kass, DeRose 1993: n = 3, weights n^2 : 4 : 1 over n (n + 5)).
TEST(Subdivide, MovesACubesCornerToItsLimit)
{
    const float limit = (9.0f * 1 + 3 * 4 * (1 / 3.0f) + 3 * 1 * (-1 / 3.0f)) / 24;
    for (const int levels : {1, 2, 4})
        EXPECT_NEAR(farthest(subdivide(cube(), levels)), limit * std::sqrt(3.0f), 1e-5) << levels;
}

TEST(Subdivide, ReproducesAPlane)
{
    const Mesh mesh = subdivide(plane_mesh({2, 2}, {3, 3}), 3);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(mesh.positions[v].z, 0, 1e-7);
        EXPECT_NEAR(mesh.normals[v].z, 1, 1e-6);
    }
    const Box box = bounding_box(mesh);
    EXPECT_EQ(box.lo, glm::dvec3(-1, -1, 0)) << "corners of the boundary stay";
    EXPECT_EQ(box.hi, glm::dvec3(1, 1, 0));
}

TEST(Subdivide, GivesUnitNormalsThatPointOut)
{
    const Mesh mesh = subdivide(cube(), 3);
    EXPECT_GT(volume(mesh), 1);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(glm::length(mesh.normals[v]), 1, 1e-5);
        EXPECT_GT(glm::dot(mesh.normals[v], glm::normalize(mesh.positions[v])), 0.8f);
    }
}

TEST(Subdivide, KeepsAnInfinitelySharpCubeACube)
{
    Mesh cage = cube();
    for (int axis = 0; axis < 3; ++axis)
        for (const float s : {-1.0f, 1.0f})
            for (const float t : {-1.0f, 1.0f}) {
                glm::vec3 a(0), b(0);
                a[axis] = -1, b[axis] = 1;
                a[(axis + 1) % 3] = b[(axis + 1) % 3] = s;
                a[(axis + 2) % 3] = b[(axis + 2) % 3] = t;
                cage.creases.push_back({vertex_at(cage, a), vertex_at(cage, b), 10});
            }
    EXPECT_NEAR(volume(subdivide(cage, 3)), 8, 1e-5);
    for (Mesh::Crease& crease : cage.creases) crease.sharpness = 1;
    const double half_sharp = volume(subdivide(cage, 3));
    EXPECT_LT(half_sharp, 7.9);
    EXPECT_GT(half_sharp, volume(subdivide(cube(), 3)) + 0.1);
}

TEST(Subdivide, KeepsASharpCorner)
{
    Mesh cage = cube();
    const std::uint32_t corner = vertex_at(cage, {1, 1, 1});
    cage.creases = {{corner, corner, 10}};
    EXPECT_NEAR(farthest(subdivide(cage, 2)), std::sqrt(3.0f), 1e-6);
}

TEST(Subdivide, KeepsSeamsOfTextureCoordinates)
{
    Mesh cage = cube();
    const Mesh mesh = subdivide(cage, 2);
    ASSERT_EQ(mesh.uvs.size(), 1u);
    EXPECT_GT(mesh.vertex_count(), point_count(mesh)) << "each side has its own square";
    for (const glm::vec2& uv : mesh.uvs[0]) {
        EXPECT_GE(std::min(uv.x, uv.y), -1e-6f);
        EXPECT_LE(std::max(uv.x, uv.y), 1 + 1e-6f);
    }
    cage.uvs.clear();
    const Mesh joined = subdivide(cage, 2);
    EXPECT_EQ(joined.vertex_count(), point_count(joined));
}

TEST(Subdivide, HandsMaterialsAndGroupsDown)
{
    Mesh cage = cube();
    cage.face_material = {0, 1, 2, 3, 4, 5};
    const Mesh mesh = subdivide(cage, 2);
    for (std::uint32_t m = 0; m < 6; ++m)
        EXPECT_EQ(std::count(mesh.face_material.begin(), mesh.face_material.end(), m), 16);
}

TEST(Subdivide, RefusesTooManyFacesAndImpossibleLevels)
{
    EXPECT_THROW(subdivide(cube(), 7), Rejected);
    EXPECT_THROW(subdivide(cube(), -1), Rejected);
    EXPECT_THROW(subdivide(plane_mesh({1, 1}, {200, 200}), 6), Rejected);
}

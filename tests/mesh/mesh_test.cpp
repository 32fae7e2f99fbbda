// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/model.h"
#include "core/mesh/pose.h"
#include "core/mesh/primitives.h"
#include "core/mesh/transform.h"
#include "tests/mesh/edges.h"

#include <bit>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

using namespace trivar;
using trivar::testing::volume;

namespace {

Mesh polygon(std::vector<glm::vec3> positions)
{
    Mesh mesh;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t v = 0; v < positions.size(); ++v) corners.push_back(v);
    mesh.positions = std::move(positions);
    add_face(mesh, corners);
    return mesh;
}

// The sum of the triangles' areas, each counted positive: equal to the polygon's area only where
// no triangle lies outside it or over another.
double covered_area(const Mesh& mesh)
{
    double area = 0;
    for (const glm::uvec3& t : triangles(mesh))
        area += glm::length(glm::cross(glm::dvec3(mesh.positions[t.y] - mesh.positions[t.x]),
                                       glm::dvec3(mesh.positions[t.z] - mesh.positions[t.x]))) /
                2;
    return area;
}

// A star whose every second corner is reflex, in a tilted plane.
Mesh star(int points)
{
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points, r = i % 2 ? 0.3 : 1.0;
        const glm::dvec3 p(r * std::cos(angle), r * std::sin(angle), 0);
        positions.emplace_back(p.x, 0.6 * p.y, 0.8 * p.y);
    }
    return polygon(positions);
}

} // namespace

TEST(Triangles, CoverAConcavePolygonExactly)
{
    const Mesh mesh = star(17);
    EXPECT_EQ(triangles(mesh).size(), 32u);
    EXPECT_NEAR(covered_area(mesh), glm::length(area_normal(mesh, 0)) / 2, 1e-6);
}

TEST(Triangles, CutAnArrowheadAtItsReflexCorner)
{
    const Mesh mesh = polygon({{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}});
    EXPECT_NEAR(covered_area(mesh), glm::length(area_normal(mesh, 0)) / 2, 1e-6);
}

TEST(Triangles, KeepTheDirectionOfTheFace)
{
    const Mesh mesh = star(9);
    const glm::dvec3 normal = area_normal(mesh, 0);
    for (const glm::uvec3& t : triangles(mesh)) {
        const glm::dvec3 n = glm::cross(glm::dvec3(mesh.positions[t.y] - mesh.positions[t.x]),
                                        glm::dvec3(mesh.positions[t.z] - mesh.positions[t.x]));
        EXPECT_GT(glm::dot(n, normal), 0);
    }
}

TEST(Triangles, AreTwoLessThanTheCornersEvenWhereThePolygonCrossesItselfOrIsAPoint)
{
    EXPECT_EQ(triangles(polygon(std::vector<glm::vec3>(7, glm::vec3(1)))).size(), 5u);
    EXPECT_EQ(triangles(polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {.5f, 3, 0}})).size(),
              3u);
}

TEST(Triangles, AreTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = sphere_mesh(1, 200, 100);
    const auto many = triangles(mesh);
    const ThreadLimit one(1);
    EXPECT_EQ(triangles(mesh), many);
}

TEST(SmoothNormals, AreTheSpheresOwn)
{
    const Mesh sphere = sphere_mesh(2, 64, 32);
    const auto normals = smooth_normals(sphere);
    for (std::size_t v = 0; v < normals.size(); ++v)
        EXPECT_GT(glm::dot(normals[v], sphere.normals[v]), 0.999f);
}

TEST(SmoothNormals, AreOneAcrossASeam)
{
    const Mesh sphere = sphere_mesh(2, 12, 6);
    const auto normals = smooth_normals(sphere);
    for (std::size_t v = 0; v < normals.size(); ++v)
        for (std::size_t w = 0; w < v; ++w)
            if (sphere.points[v] == sphere.points[w]) {
                EXPECT_EQ(normals[v], normals[w]);
            }
}

TEST(SmoothNormals, PointUpWhereThereIsNoArea)
{
    EXPECT_EQ(smooth_normals(polygon({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}))[0], glm::vec3(0, 0, 1));
}

TEST(Transformed, ByAMirrorKeepsTheOutsideOut)
{
    const Mesh box = box_mesh({1, 2, 3}, {2, 2, 2});
    const glm::dmat4 mirror =
        glm::rotate(glm::scale(glm::dmat4(1), {-2, 1, 1}), 0.7, glm::dvec3(1, 2, 3));
    const Mesh mapped = transformed(box, mirror);
    EXPECT_NEAR(volume(mapped), 12, 1e-4);
    for (std::size_t f = 0; f < mapped.face_count(); ++f) {
        const glm::dvec3 n = glm::normalize(area_normal(mapped, f));
        for (std::uint32_t c = mapped.face_begin[f]; c < mapped.face_begin[f + 1]; ++c)
            EXPECT_NEAR(glm::dot(n, glm::dvec3(mapped.normals[mapped.corners[c]])), 1, 1e-5);
    }
}

TEST(Transformed, AgainIsAsFromTheStart)
{
    Mesh torus = torus_mesh(2, 0.5, {160, 80});
    torus.tangents.assign(torus.vertex_count(), glm::vec4(0.6f, 0.8f, 0, -1));
    const glm::dmat4 turn =
        glm::translate(glm::rotate(glm::dmat4(1), 1.0, glm::dvec3(0, 1, 0)), glm::dvec3(1, 2, 3));
    for (const double x : {1.0, -1.0}) {
        const glm::dmat4 scale = glm::scale(glm::dmat4(1), glm::dvec3(2 * x, 1, 3));
        Mesh again = transformed(torus, scale);
        transform_again(again, torus, turn * scale);
        EXPECT_EQ(again, transformed(torus, turn * scale));
    }
}

TEST(Transformed, TwiceByInverseMatricesIsTheMeshAgain)
{
    const Mesh torus = torus_mesh(2, 0.5, {16, 8});
    const glm::dmat4 m =
        glm::translate(glm::rotate(glm::dmat4(1), 1.0, glm::dvec3(0, 1, 0)), glm::dvec3(1, 2, 3));
    const Mesh back = transformed(transformed(torus, m), glm::inverse(m));
    for (std::size_t v = 0; v < torus.vertex_count(); ++v) {
        EXPECT_LT(glm::distance(back.positions[v], torus.positions[v]), 2e-6f);
        EXPECT_LT(glm::distance(back.normals[v], torus.normals[v]), 2e-6f);
    }
}

TEST(PointsByPosition, JoinNothingThatIsNotEqual)
{
    const float next = std::nextafter(1.0f, 2.0f);
    const std::vector<glm::vec3> positions{{1, 0, 0}, {next, 0, 0}, {1, -0.0f, 0}, {1, 0, 0}};
    EXPECT_EQ(points_by_position(positions), (std::vector<std::uint32_t>{0, 1, 0, 0}));
}

// The hash multiplies by this number, so these land in few slots; sorting has to give the answer.
TEST(PointsByPosition, AreRightForPositionsThatCollide)
{
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> expected;
    std::uint64_t value = 1;
    const auto hash = [](float z) {
        // x = y = 0 leave the hash 0, so z alone decides.
        const std::uint64_t h = std::bit_cast<std::uint32_t>(z) * 0x9e3779b97f4a7c15u;
        return (h ^ h >> 29) & 0xffff;
    };
    for (std::uint32_t bits = 0x3f800000; positions.size() < 800; bits += 1) {
        const float z = std::bit_cast<float>(bits);
        if (hash(z) >= 4) continue;
        positions.emplace_back(0, 0, z);
        expected.push_back(static_cast<std::uint32_t>(value++ - 1));
    }
    positions.push_back(positions[5]);
    expected.push_back(5);
    EXPECT_EQ(points_by_position(positions), expected);
}

TEST(LooseVertices, AreDroppedAndTheRestKeepsItsValues)
{
    Mesh mesh = plane_mesh({1, 1}, {2, 2});
    const Mesh before = mesh;
    mesh.positions.insert(mesh.positions.begin(), glm::vec3(9));
    mesh.normals.insert(mesh.normals.begin(), glm::vec3(1, 0, 0));
    mesh.uvs[0].insert(mesh.uvs[0].begin(), glm::vec2(9));
    for (std::uint32_t& v : mesh.corners) ++v;
    EXPECT_EQ(without_loose_vertices(mesh), before);
}

TEST(LooseVertices, TakeTheNumbersOfTheirPointsAlong)
{
    Mesh seam; // 1 and 3 are one point; 0 is loose, and so is 2, which is the point of 4
    seam.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    seam.points = points_by_position(seam.positions);
    add_face(seam, std::array{1u, 4u, 5u});
    add_face(seam, std::array{3u, 5u, 4u});
    const Mesh mesh = without_loose_vertices(seam);
    EXPECT_EQ(mesh.points, points_by_position(mesh.positions));
    EXPECT_NO_THROW(validate(mesh, "seam"));
}

TEST(Validate, AcceptsEveryPrimitive)
{
    for (const Mesh& mesh : {plane_mesh({1, 1}, {3, 3}), box_mesh({1, 1, 1}, {1, 2, 3}),
                             moebius_mesh(1, 0.3, {30, 3}), teapot_mesh(1, 3)})
        EXPECT_NO_THROW(validate(mesh, "primitive"));
}

TEST(Validate, RefusesEachKindOfDamage)
{
    const Mesh good = box_mesh({1, 1, 1}, {1, 1, 1});
    const auto refused = [&](auto damage) {
        Mesh mesh = good;
        damage(mesh);
        EXPECT_THROW(validate(mesh, "box"), Rejected);
    };
    refused([](Mesh& m) { m.positions[3].y = std::numeric_limits<float>::quiet_NaN(); });
    refused([](Mesh& m) { m.uvs[0][3].y = std::numeric_limits<float>::infinity(); });
    refused([](Mesh& m) { m.normals.pop_back(); });
    refused([](Mesh& m) { m.corners[5] = 24; });
    refused([](Mesh& m) { m.points[5] = 24; });
    refused([](Mesh& m) { m.face_begin[2] = 6; });
    refused([](Mesh& m) { m.face_begin[2] = 2; });
    refused([](Mesh& m) { m.face_begin.back() = 23; });
    refused([](Mesh& m) { m.face_group = {0}; });
    refused([](Mesh& m) { m.creases = {{0, 99, 1}}; });
}

TEST(Model, PlacesANodeByEveryMatrixUpToTheRoot)
{
    Model model = single_mesh_model("box", box_mesh({2, 2, 2}, {1, 1, 1}));
    model.nodes[0].mesh = -1;
    model.nodes[0].to_parent = glm::translate(glm::dmat4(1), {10, 0, 0});
    model.nodes.push_back({"child", 0, glm::scale(glm::dmat4(1), {2, 1, 1}), 0});
    EXPECT_EQ(bounding_box(model).lo, glm::dvec3(8, -1, -1));
    EXPECT_EQ(bounding_box(model).hi, glm::dvec3(12, 1, 1));
    EXPECT_EQ(model.materials.size(), 1u);
}

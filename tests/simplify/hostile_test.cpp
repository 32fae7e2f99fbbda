// SPDX-License-Identifier: GPL-3.0-or-later
// What no half-edge mesh holds stays as it is, and no face is lost.
#include "core/simplify/fans.h"
#include "tests/mesh/edges.h"
#include "tests/simplify/meshes.h"

#include <gtest/gtest.h>
#include <set>

namespace trivar::testing {
namespace {

// Three sheets that meet in the line y = z = 0.
Mesh three_sheets()
{
    Mesh out;
    for (int wing = 0; wing < 3; ++wing) {
        Mesh sheet = plane_mesh({2, 2}, {8, 8});
        const float angle = static_cast<float>(wing) * 2.1f;
        const auto first = static_cast<std::uint32_t>(out.vertex_count());
        for (const glm::vec3& p : sheet.positions)
            out.positions.emplace_back(p.x, (p.y + 1) * std::cos(angle),
                                       (p.y + 1) * std::sin(angle));
        for (std::size_t f = 0; f < sheet.face_count(); ++f) {
            std::array<std::uint32_t, 4> face{};
            for (std::size_t i = 0; i < 4; ++i) face[i] = first + sheet.corners[4 * f + i];
            add_face(out, face);
        }
    }
    for (glm::vec3& p : out.positions) p += 0.0f; // no minus zero
    out.points = points_by_position(out.positions);
    return out;
}

using Places = std::multiset<std::array<float, 9>>;
Places places(const Mesh& mesh)
{
    Places out;
    for (const glm::uvec3& t : triangles(mesh)) {
        std::array<float, 9> all{};
        for (int i = 0; i < 9; ++i)
            all[static_cast<std::size_t>(i)] = mesh.positions[t[i / 3]][i % 3];
        out.insert(all);
    }
    return out;
}

// Triangles between any of few points, also one point twice.
Mesh soup(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(-1, 1);
    Mesh mesh;
    for (int v = 0; v < 40; ++v)
        mesh.positions.emplace_back(place(random), place(random), place(random));
    for (int f = 0; f < 60; ++f)
        add_face(mesh, std::array{static_cast<std::uint32_t>(random() % 40),
                                  static_cast<std::uint32_t>(random() % 40),
                                  static_cast<std::uint32_t>(random() % 40)});
    return mesh;
}

Mesh with(Mesh mesh, const Mesh& more)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
    mesh.normals.clear(), mesh.tangents.clear(), mesh.uvs.clear();
    for (const glm::uvec3& t : triangles(more))
        add_face(mesh, std::array{first + t.x, first + t.y, first + t.z});
    mesh.points = points_by_position(mesh.positions);
    return mesh;
}

} // namespace

TEST(SimplifyHostile, AnEmptyMeshStaysEmpty)
{
    EXPECT_EQ(to_number({}, 0).triangles, 0u);
    EXPECT_EQ(to_error({}, 1).triangles, 0u);
    Mesh loose;
    loose.positions = {{0, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(to_error(loose, 1).mesh->vertex_count(), 2u);
}

TEST(SimplifyHostile, FacesRoundAnEdgeOfThreeStayAndTheSheetsDoNotComeApart)
{
    const Mesh mesh = three_sheets();
    const SimplifiedMesh less = to_error(mesh, 0.001);
    EXPECT_EQ(less.left_out, 24u); // eight edges, three triangles each
    EXPECT_LT(less.triangles, 150u);
    EXPECT_NEAR(area(*less.mesh), area(mesh), 1e-5);
    EXPECT_EQ(count_edges(*less.mesh).crowded, 8);
    EXPECT_EQ(count_edges(*less.mesh).open, count_edges(*to_error(mesh, 0.001).mesh).open);
    EXPECT_LE(sampled_distance(mesh, *less.mesh, 5), 0.001);
}

TEST(SimplifyHostile, BodiesThatTouchInAPointStayTogether)
{
    Mesh other = sphere_mesh(1, 24, 16);
    for (glm::vec3& p : other.positions) p.z += 2; // pole on pole
    const Mesh mesh = with(sphere_mesh(1, 24, 16), other);
    const Mesh less = *to_number(mesh, 300).mesh;
    EXPECT_LE(triangles(less).size(), 300u);
    EXPECT_EQ(count_edges(less).open, 0);
    EXPECT_EQ(count_edges(less).points - count_edges(less).edges +
                  static_cast<int>(less.face_count()),
              3);
}

// A sphere with some of its points drawn together, which others are neighbours of on both sides.
TEST(SimplifyHostile, PointsOfSeveralFansGetNoEdgeOfThree)
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        Mesh mesh = with(sphere_mesh(1, 12, 8), {});
        for (int pair = 0; pair < 6; ++pair) {
            const std::size_t v = random() % mesh.vertex_count(),
                              w = random() % mesh.vertex_count();
            const glm::vec3 from = mesh.positions[w], to = mesh.positions[v];
            std::ranges::replace(mesh.positions, from, to);
        }
        mesh.points = points_by_position(mesh.positions);
        const auto tally = [](const Mesh& of) {
            Mesh cut = of;
            cut.corners.clear(), cut.face_begin = {0};
            for (const glm::uvec3& t : triangles(of)) add_face(cut, std::array{t.x, t.y, t.z});
            const EdgeCount count = count_edges(cut);
            const int faces = static_cast<int>(cut.face_count());
            return std::array{count.crowded, count.open, count.points - count.edges + faces};
        };
        const SimplifiedMesh less = to_number(mesh, 0);
        EXPECT_LT(less.triangles, less.triangles_before);
        EXPECT_EQ(tally(*less.mesh), tally(mesh)) << seed;
    }
}

TEST(SimplifyHostile, FacesThatRepeatAPointStay)
{
    Mesh mesh = bumpy_torus({24, 16});
    mesh.uvs.clear(), mesh.tangents.clear();
    add_face(mesh, std::array{0u, 1u, 1u});
    add_face(mesh, std::array{5u, 5u, 5u});
    const SimplifiedMesh less = to_number(mesh, 200);
    EXPECT_GE(less.left_out, 2u);
    int repeated = 0;
    for (const glm::uvec3& t : triangles(*less.mesh)) repeated += t.x == t.y || t.y == t.z;
    EXPECT_EQ(repeated, 2);
    EXPECT_LE(less.triangles, 200u + less.left_out);
}

TEST(SimplifyHostile, TrianglesWithoutAreaDoNoHarm)
{
    Mesh sheet = plane_mesh({2, 2}, {12, 12});
    for (glm::vec3& p : sheet.positions)
        if (p.x > 0.4f) p.x = 0.5f; // several columns in one line, apart as points
    const SimplifiedMesh less = to_error(sheet, 1e-4);
    EXPECT_LT(less.triangles, less.triangles_before);
    EXPECT_NEAR(area(*less.mesh), area(sheet), 1e-5);
    for (const glm::vec3& n : less.mesh->normals) EXPECT_NEAR(glm::length(n), 1, 1e-5);
}

TEST(SimplifyHostile, ASoupKeepsEveryFaceThatWasLeftOut)
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Mesh mesh = soup(seed);
        const Fans fans = fans_of(mesh);
        Mesh left_out = mesh;
        left_out.corners.clear(), left_out.face_begin = {0};
        for (std::size_t t = 0; t < fans.triangles.size(); ++t)
            if (fans.nodes[t].x == Fans::none) {
                const glm::uvec3 v = fans.triangles[t];
                add_face(left_out, std::array{v.x, v.y, v.z});
            }
        const SimplifiedMesh less = to_number(mesh, 0);
        EXPECT_EQ(less.left_out, left_out.face_count());
        const Places kept = places(*less.mesh), wanted = places(left_out);
        EXPECT_TRUE(std::ranges::includes(kept, wanted)) << seed;
        EXPECT_NO_THROW(validate(*less.mesh, "less"));
        EXPECT_LE(sampled_distance(mesh, *to_error(mesh, 0.2).mesh, 20), 0.2);
    }
}

TEST(SimplifyHostile, ManyVerticesOfOnePointTakeNoSquareOfTime)
{
    Mesh mesh; // a fan round one point, split everywhere
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const float a = static_cast<float>(i) / 20000 * 6.28f,
                    b = static_cast<float>(i + 1) / 20000 * 6.28f;
        mesh.positions.insert(
            mesh.positions.end(),
            {{0, 0, 0}, {std::cos(a), std::sin(a), 0}, {std::cos(b), std::sin(b), 0}});
        mesh.colors.insert(mesh.colors.end(), 3, glm::vec4(a));
        add_face(mesh, std::array{3 * i, 3 * i + 1, 3 * i + 2});
    }
    mesh.points = points_by_position(mesh.positions);
    EXPECT_EQ(to_number(mesh, 100).triangles, 20000u); // every edge is a line between colours
}

} // namespace trivar::testing

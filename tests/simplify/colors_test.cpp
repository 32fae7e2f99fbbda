// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted on a mesh stays, also where its shape would need no triangle.
#include "tests/mesh/edges.h"
#include "tests/simplify/meshes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

// A flat sheet with a blue disc, whose rim is soft.
glm::vec3 painting(const glm::vec3& p)
{
    const float rim = glm::smoothstep(0.45f, 0.6f, glm::length(glm::vec2(p) - glm::vec2(0.2, 0.1)));
    return glm::mix(glm::vec3(0.1, 0.2, 0.9), glm::vec3(0.9), rim);
}

Mesh painted_sheet(int segments)
{
    Mesh mesh = plane_mesh({2, 2}, {segments, segments});
    for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(painting(p), 1);
    return mesh;
}

// The mean difference of the colours over the sheet from the painting.
double off(const Mesh& mesh)
{
    double sum = 0, whole = 0;
    for (const glm::uvec3& t : triangles(mesh)) {
        const auto p = [&](int k) { return mesh.positions[t[k]]; };
        const float area = glm::length(glm::cross(p(1) - p(0), p(2) - p(0))) / 2;
        constexpr int n = 12;
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                const float a = (float(i) + 1 / 3.0f) / n, b = (float(j) + 1 / 3.0f) / n;
                const auto mixed = [&](const auto& x) {
                    return glm::vec3(x[t.x] * (1 - a - b) + x[t.y] * a + x[t.z] * b);
                };
                sum += double(area) *
                       glm::distance(mixed(mesh.colors), painting(mixed(mesh.positions)));
                whole += area;
            }
    }
    return sum / whole;
}

} // namespace

TEST(SimplifyColors, KeepsThePaintingOfAFlatSheet)
{
    const Mesh sheet = painted_sheet(40); // 3,200 triangles
    EXPECT_LE(off(*to_number(sheet, 320).mesh), 0.01);
    EXPECT_LE(off(*to_number(sheet, 160).mesh), 0.03);
    EXPECT_LE(off(*to_number(sheet, 80).mesh), 0.06);
}

TEST(SimplifyColors, BoundAnErrorToo)
{
    const Mesh sheet = painted_sheet(40);
    for (const double error : {1e-3, 0.01, 1.0}) {
        const SimplifiedMesh less = to_error(sheet, error);
        EXPECT_LT(less.triangles, 2000u);
        EXPECT_LE(off(*less.mesh), 0.06) << error;
    }
}

TEST(SimplifyColors, OfOneColourCostNothing)
{
    Mesh sheet = painted_sheet(20);
    for (glm::vec4& color : sheet.colors) color = glm::vec4(0.3f, 0.5f, 0.7f, 1);
    EXPECT_EQ(to_number(sheet, 2).triangles, 2u);
    EXPECT_EQ(to_error(sheet, 1e-3).triangles, 2u);
}

TEST(SimplifyColors, LetSeamsOfTwoColoursBothSidesCount)
{
    Mesh sheet = plane_mesh({2, 2}, {24, 24}); // red left of the middle line, blue right of it
    const std::size_t count = sheet.vertex_count();
    sheet.points.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) sheet.points[v] = v;
    sheet.colors.assign(count, {1, 0, 0, 1});
    std::vector<std::uint32_t> twin(count, ~0u);
    for (std::size_t f = 0; f < sheet.face_count(); ++f) {
        const auto corner = [&](std::uint32_t c) -> std::uint32_t& { return sheet.corners[c]; };
        float middle = 0;
        for (std::uint32_t c = sheet.face_begin[f]; c < sheet.face_begin[f + 1]; ++c)
            middle += sheet.positions[corner(c)].x;
        if (middle < 0) continue;
        for (std::uint32_t c = sheet.face_begin[f]; c < sheet.face_begin[f + 1]; ++c) {
            const std::uint32_t v = corner(c);
            if (twin[v] == ~0u) {
                twin[v] = static_cast<std::uint32_t>(sheet.vertex_count());
                sheet.positions.push_back(glm::vec3(sheet.positions[v]));
                sheet.normals.push_back(glm::vec3(sheet.normals[v]));
                for (auto& set : sheet.uvs) set.push_back(glm::vec2(set[v]));
                sheet.points.push_back(v);
                sheet.colors.emplace_back(0, 0, 1, 1);
            }
            corner(c) = twin[v];
        }
    }
    const Mesh less = *to_number(without_loose_vertices(sheet), 4).mesh;
    EXPECT_LE(triangles(less).size(), 8u);
    for (std::size_t v = 0; v < less.vertex_count(); ++v)
        EXPECT_EQ(less.colors[v].x > 0.5f,
                  less.positions[v].x < 0 || (less.positions[v].x == 0 && less.colors[v].x == 1));
}

// Faces at an edge with more than two of them cannot be simplified.
TEST(SimplifyShare, OfWhatCannotBeSimplifiedIsNotTakenFromTheRest)
{
    Mesh ball = bumpy_torus({60, 40});
    const std::size_t before = triangles(ball).size(), faces = ball.face_count();
    for (std::size_t f = 0; f < faces / 5; ++f) {
        const std::vector<std::uint32_t> face(ball.corners.begin() + ball.face_begin[f],
                                              ball.corners.begin() + ball.face_begin[f + 1]);
        add_face(ball, face);
    }
    const SimplifiedMesh less = to_number(ball, triangles(ball).size() / 10);
    EXPECT_GT(less.left_out, before / 3);
    const std::size_t rest = triangles(ball).size() - less.left_out;
    EXPECT_GE(less.triangles - less.left_out, rest / 10);
    EXPECT_LE(less.triangles - less.left_out, rest / 8);
}

} // namespace trivar::testing

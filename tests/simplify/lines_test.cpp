// SPDX-License-Identifier: GPL-3.0-or-later
// Borders, seams, creases and the lines between materials stay; so does what a vertex has.
#include "core/files/read_model.h"
#include "tests/mesh/edges.h"
#include "tests/simplify/meshes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

namespace trivar::testing {
namespace {

// Twice the area of texture coordinates of each triangle.
std::vector<double> uv_areas(const Mesh& mesh)
{
    std::vector<double> out;
    for (const glm::uvec3& t : triangles(mesh)) {
        const auto uv = [&](int i) { return glm::dvec2(mesh.uvs[0][t[i]]); };
        const glm::dvec2 a = uv(1) - uv(0), b = uv(2) - uv(0);
        out.push_back(a.x * b.y - a.y * b.x);
    }
    return out;
}

double length_of_creases(const Mesh& mesh)
{
    double sum = 0;
    for (const Mesh::Crease& c : mesh.creases)
        sum += glm::distance(mesh.positions[c.a], mesh.positions[c.b]);
    return sum;
}

Mesh wavy_sheet()
{
    Mesh mesh = plane_mesh({2, 2}, {24, 24});
    for (glm::vec3& p : mesh.positions) p.z = 0.2f * std::sin(3 * p.x) * std::cos(2 * p.y);
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

} // namespace

TEST(SimplifyLines, KeepsTheOutlineOfASheet)
{
    const Mesh sheet = plane_mesh({3, 2}, {12, 9});
    const SimplifiedMesh less = to_number(sheet, 2);
    EXPECT_EQ(less.triangles, 2u);
    EXPECT_NEAR(area(*less.mesh), 6, 1e-6);
}

TEST(SimplifyLines, PutsBordersOnPointsOfTheBorder)
{
    const Mesh sheet = wavy_sheet();
    const Mesh less = *to_number(sheet, 200).mesh;
    const EdgeCount count = count_edges(less);
    EXPECT_GT(count.open, 8);
    EXPECT_LT(count.open, 96);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const glm::uvec3& t : triangles(less))
        for (int i = 0; i < 3; ++i)
            ++uses[std::minmax(less.point(t[i]), less.point(t[(i + 1) % 3]))];
    for (const auto& [edge, n] : uses)
        if (n == 1) {
            const glm::vec3 p = glm::abs(less.positions[edge.first]);
            EXPECT_FLOAT_EQ(std::max(p.x, p.y), 1);
        }
}

TEST(SimplifyLines, KeepsSeamsOfTextureCoordinates)
{
    const Mesh torus = bumpy_torus({64, 32});
    for (const std::size_t n : {2000, 400, 100}) {
        const Mesh less = *to_number(torus, n).mesh;
        EXPECT_EQ(count_edges(less).open, 0); // closed in position
        EXPECT_TRUE(has_vertices_of(less, torus));
        double sum = 0;
        for (const double area : uv_areas(less)) {
            EXPECT_GT(area, 0);
            sum += area;
        }
        EXPECT_NEAR(sum, 2, 1e-5); // all of the unit square, once
    }
}

TEST(SimplifyLines, DoesNotHoldOnToThePolesOfASphere)
{
    const Mesh less = *to_number(sphere_mesh(1, 64, 32), 200).mesh;
    EXPECT_NEAR(volume(less), 4.18, 0.4);
    for (const double area : uv_areas(less)) EXPECT_GT(area, 0);
}

TEST(SimplifyLines, KeepsTheLineBetweenMaterials)
{
    Mesh sheet = plane_mesh({2, 2}, {16, 16});
    double before = 0;
    for (std::size_t f = 0; f < sheet.face_count(); ++f) {
        const glm::vec3 p = sheet.positions[sheet.corners[sheet.face_begin[f]]];
        sheet.face_material.push_back(p.x + 0.3f * p.y > 0.2f); // a staircase
        if (sheet.face_material.back() == 1) before += glm::length(area_normal(sheet, f)) / 2;
    }
    const Mesh less = *to_error(sheet, 0).mesh;
    EXPECT_LT(less.face_count(), 64u);
    double after = 0;
    for (std::size_t f = 0; f < less.face_count(); ++f)
        if (less.face_material[f] == 1) after += glm::length(area_normal(less, f)) / 2;
    EXPECT_NEAR(after, before, 1e-6);
}

TEST(SimplifyLines, KeepsCreasesAndTheirSharpness)
{
    Mesh sheet = plane_mesh({2, 2}, {8, 8});
    for (std::uint32_t v = 0; v < sheet.vertex_count(); ++v)
        for (std::uint32_t w = 0; w < v; ++w)
            if (sheet.positions[v].y == 0 && sheet.positions[w].y == 0 &&
                glm::distance(sheet.positions[v], sheet.positions[w]) < 0.26f)
                sheet.creases.push_back({v, w, sheet.positions[v].x > 0 ? 3.0f : 5.0f});
    sheet.creases.push_back({0, 0, 10});
    const Mesh less = *to_number(sheet, 4).mesh;
    EXPECT_LT(less.creases.size(), sheet.creases.size());
    EXPECT_FLOAT_EQ(static_cast<float>(length_of_creases(less)), 2);
    std::map<float, int> by_sharpness;
    for (const Mesh::Crease& c : less.creases) ++by_sharpness[c.sharpness];
    EXPECT_EQ(by_sharpness, (std::map<float, int>{{3, 1}, {5, 1}, {10, 1}}));
    EXPECT_NO_THROW(validate(less, "less"));
}

TEST(SimplifyLines, LeavesFacetsFacets)
{
    Mesh ball = sphere_mesh(1, 32, 24), facets;
    for (const Triangle3& t : placed_triangles(ball)) {
        const glm::vec3 normal(glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])));
        const auto first = static_cast<std::uint32_t>(facets.vertex_count());
        for (const glm::dvec3& p : t) {
            facets.positions.emplace_back(p);
            facets.normals.push_back(normal);
        }
        add_face(facets, std::array{first, first + 1, first + 2});
    }
    facets.points = points_by_position(facets.positions);
    const SimplifiedMesh less = to_number(facets, 300);
    EXPECT_LE(less.triangles, 300u);
    for (std::size_t f = 0; f < less.mesh->face_count(); ++f)
        for (std::uint32_t c = less.mesh->face_begin[f]; c < less.mesh->face_begin[f + 1]; ++c)
            EXPECT_GT(glm::dot(glm::dvec3(less.mesh->normals[less.mesh->corners[c]]),
                               glm::normalize(area_normal(*less.mesh, f))),
                      0.9999);
}

TEST(SimplifyLines, TakesNormalsAnewFromTheFacesThatAreLeft)
{
    Mesh torus = bumpy_torus({48, 24});
    torus.uvs.clear(); // no seams
    torus.tangents.clear();
    const Mesh less = *to_number(torus, 500).mesh;
    const std::vector<glm::vec3> expected = smooth_normals(less);
    ASSERT_EQ(less.normals.size(), expected.size());
    for (std::size_t v = 0; v < expected.size(); ++v)
        EXPECT_GT(glm::dot(less.normals[v], expected[v]), 0.9999f);
}

TEST(SimplifyLines, KeepsWhatMovesAVertexAndItsColour)
{
    Mesh torus = bumpy_torus({32, 16});
    for (std::size_t v = 0; v < torus.vertex_count(); ++v) {
        const glm::vec3 p = torus.positions[v];
        torus.colors.emplace_back(p, 1);
        torus.influences.push_back({{static_cast<std::uint16_t>(p.x > 0), 0, 0, 0}, {1, 0, 0, 0}});
    }
    Mesh::MorphTarget& target = torus.morph_targets.emplace_back();
    for (const glm::vec3& p : torus.positions) target.positions.push_back(0.1f * p);
    const Mesh less = *to_number(torus, 200).mesh;
    EXPECT_EQ(less.influences.size(), less.vertex_count());
    EXPECT_TRUE(has_vertices_of(less, torus));
    EXPECT_NO_THROW(validate(less, "less"));
}

TEST(SimplifyLines, KeepsWhatBendsInAPose)
{
    const Mesh bar = plane_mesh({4, 1}, {64, 1}); // flat at rest, an arc in the pose
    std::vector<glm::vec3> arc;
    for (const glm::vec3& p : bar.positions) arc.emplace_back(std::sin(p.x), p.y, std::cos(p.x));
    const auto at_error = [&](std::vector<std::vector<glm::vec3>> poses) {
        return simplified(make_ref(bar),
                          {.triangles = {}, .error = 0.02, .poses = std::move(poses)});
    };
    EXPECT_EQ(at_error({}).triangles, 2u);
    const SimplifiedMesh less = at_error({arc});
    EXPECT_GE(less.triangles, 12u);
    EXPECT_LT(less.triangles, 64u);
    Mesh target = bar; // a morph target counts as a pose does
    target.morph_targets.push_back({{}, {}, {}});
    for (std::size_t v = 0; v < arc.size(); ++v)
        target.morph_targets[0].positions.push_back(arc[v] - bar.positions[v]);
    EXPECT_EQ(to_error(target, 0.02).triangles, less.triangles);
}

// Two patches of one surface, as an OBJ has them whose program wrote the border of each.
TEST(SimplifyLines, LeavesNoSlitBetweenPatchesOfAFile)
{
    std::string text;
    for (const int side : {0, 1})
        for (int i = 0; i <= 20; ++i)
            for (int j = 0; j <= 20; ++j) {
                const double x = side + i / 20.0, y = j / 20.0;
                text += fmt::format("v {:.9f} {:.9f} {:.9f}\n", x, y,
                                    0.1 * std::sin(4 * x) * std::cos(5 * y));
            }
    for (const int side : {0, 1})
        for (int i = 0; i < 20; ++i)
            for (int j = 0; j < 20; ++j) {
                const int v = 441 * side + 21 * i + j + 1;
                text += fmt::format("f {} {} {} {}\n", v, v + 21, v + 22, v + 1);
            }
    const Mesh patches = *read_model_bytes(text, "patches.obj", "", {.up = UpAxis::z}).meshes[0];
    EXPECT_EQ(count_edges(patches).open, 120);
    for (const std::size_t triangles : {400, 150, 60}) {
        Mesh less = *to_number(patches, triangles).mesh;
        less.points = points_by_position(less.positions);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
        for (const glm::uvec3& t : trivar::triangles(less))
            for (int i = 0; i < 3; ++i)
                ++uses[std::minmax(less.point(t[i]), less.point(t[(i + 1) % 3]))];
        std::vector<glm::vec3> at(less.vertex_count());
        for (std::size_t v = 0; v < at.size(); ++v) at[less.points[v]] = less.positions[v];
        for (const auto& [edge, faces] : uses) {
            const glm::vec3 middle = (at[edge.first] + at[edge.second]) / 2.0f;
            const bool outline = middle.x < 1e-6f || middle.x > 2 - 1e-6f || middle.y < 1e-6f ||
                                 middle.y > 1 - 1e-6f;
            if (!outline) {
                EXPECT_EQ(faces, 2);
            }
        }
    }
}

} // namespace trivar::testing

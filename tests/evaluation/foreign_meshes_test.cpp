// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of other programs, as objects of a scene.
#include "core/commands/cutting/cut.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/simplify.h"
#include "core/files/write_model.h"
#include "core/mesh/primitives.h"
#include "tests/mesh/edges.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <bit>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;

class ForeignMeshes : public ::testing::Test {
protected:
    Document imported(const std::string& name, const std::string& bytes)
    {
        testing::write_file(folder_.file(name), bytes);
        ImportModel import;
        import.file.path = folder_.file(name);
        import.file.up = UpAxis::z;
        return after({}, import);
    }
    Ref<EvaluatedObject> result(const Document& document)
    {
        return testing::new_evaluator()(document).objects.at(1);
    }
    // Returns all parts as another program reads them, by their places.
    Mesh exported(const Document& document)
    {
        const std::string path = folder_.file("out.stl");
        write_model(model_of(testing::new_evaluator()(document), document), path);
        return *read_model(path).meshes.at(0);
    }

private:
    testing::TemporaryFolder folder_;
};

std::string obj_of(const Mesh& mesh)
{
    std::string text;
    for (const glm::vec3& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        text += "f";
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            text += fmt::format(" {}", mesh.point(mesh.corners[c]) + 1);
        text += "\n";
    }
    return text;
}

Mesh welded(Mesh mesh)
{
    mesh.points = points_by_position(mesh.positions);
    Mesh out;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.points[v] == out.positions.size()) out.positions.push_back(mesh.positions[v]);
    for (const std::uint32_t v : mesh.corners) out.corners.push_back(mesh.points[v]);
    out.face_begin = mesh.face_begin;
    return out;
}

} // namespace

TEST_F(ForeignMeshes, WithDoubledFacesKeepAllOfTheirShapeWhenTheyAreSimplified)
{
    Mesh ball = welded(sphere_mesh(1, 40, 20));
    const std::size_t faces = ball.face_count();
    for (std::size_t f = 0; f < faces / 5; ++f) {
        const std::vector<std::uint32_t> face(ball.corners.begin() + ball.face_begin[f],
                                              ball.corners.begin() + ball.face_begin[f + 1]);
        add_face(ball, face);
    }
    const Document whole = imported("ball.obj", obj_of(ball));
    EXPECT_THAT(result(whole)->notices, ElementsAre(HasSubstr("faces lay on others")));
    const Ref<EvaluatedObject> less = result(after(whole, Simplify{{1}, {.keep = 0.25}}));
    EXPECT_NEAR(double(less->triangles) / double(less->triangles_before), 0.25, 0.01);
    const Mesh& mesh = *less->parts.at(0).mesh();
    EXPECT_EQ(testing::count_edges(mesh).open, 0);
    EXPECT_NEAR(testing::volume(mesh), 4.1, 0.15);
}

// A blue square on a white sheet, which three triangles cannot show.
TEST_F(ForeignMeshes, KeepWhatIsPaintedOnThemAndSayThatMoreStays)
{
    std::string text = "ply\nformat ascii 1.0\nelement vertex 81\nproperty float x\nproperty float "
                       "y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty "
                       "uchar blue\nelement face 64\nproperty list uchar int vertex_indices\n"
                       "end_header\n";
    const auto is_blue = [](int i) { return i > 0 && i < 8; };
    for (int y = 0; y <= 8; ++y)
        for (int x = 0; x <= 8; ++x)
            text += fmt::format("{} {} 0 {}\n", x / 8.0, y / 8.0,
                                is_blue(x) && is_blue(y) ? "0 60 160" : "255 255 255");
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            text += fmt::format("4 {} {} {} {}\n", 9 * y + x, 9 * y + x + 1, 9 * y + x + 10,
                                9 * y + x + 9);
    const Document document = after(imported("a.ply", text), Simplify{{1}, {.keep = 0.03}});
    const Ref<EvaluatedObject> less = result(document);
    EXPECT_LE(less->triangles, 20u);
    EXPECT_THAT(less->notices, ElementsAre(HasSubstr("of its 128 triangles, where 3 % were")));
    const Mesh& mesh = *less->parts.at(0).mesh();
    double blue = 0; // of the area, by the shares of corners
    for (const glm::uvec3& t : triangles(mesh)) {
        const auto p = [&](int k) { return mesh.positions[t[k]]; };
        const double area = glm::length(glm::cross(p(1) - p(0), p(2) - p(0))) / 2;
        for (int k = 0; k < 3; ++k) blue += mesh.colors[t[k]].x < 0.5f ? area / 3 : 0;
    }
    EXPECT_NEAR(blue, 0.75 * 0.75 + 4 * 0.75 * 0.125 / 2, 0.03);
}

TEST_F(ForeignMeshes, OneBitOffAreCutIntoClosedPieces)
{
    Mesh box = box_mesh(glm::dvec3(1), glm::ivec3(1));
    std::string stl(80, ' ');
    const auto put = [&](const auto& value) {
        stl.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    const std::vector<glm::uvec3> all = triangles(box);
    put(static_cast<std::uint32_t>(all.size()));
    for (const glm::uvec3& t : all) {
        put(glm::vec3(0));
        const bool is_top =
            box.positions[t.x].z > 0 && box.positions[t.y].z > 0 && box.positions[t.z].z > 0;
        for (int k = 0; k < 3; ++k) {
            glm::vec3 p = box.positions[t[k]];
            if (is_top) p.z = std::bit_cast<float>(std::bit_cast<std::uint32_t>(p.z) + 1);
            put(p);
        }
        put(std::uint16_t{0});
    }
    const Document whole = imported("box.stl", stl);
    EXPECT_THAT(result(whole)->notices, IsEmpty());
    const Document cut =
        after(whole,
              CutThrough{.objects = {1}, .cutting = {.cuts = {{.normal = {1, 0, 0}, .gap = 0.2}}}});
    EXPECT_THAT(result(cut)->notices, IsEmpty());
    EXPECT_EQ(testing::count_edges(exported(cut)).open, 0);
}

TEST_F(ForeignMeshes, ThatAreInsideOutAreTurnedAndSaySo)
{
    Mesh ball = welded(sphere_mesh(1, 24, 12));
    for (std::size_t f = 0; f < ball.face_count(); ++f)
        std::reverse(ball.corners.begin() + ball.face_begin[f],
                     ball.corners.begin() + ball.face_begin[f + 1]);
    const Document document = imported("ball.obj", obj_of(ball));
    EXPECT_THAT(result(document)->notices, ElementsAre(HasSubstr("1 closed part was inside out")));
    EXPECT_GT(testing::volume(exported(document)), 3.9);
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/image.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/pose.h"
#include "tests/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

Model through_file(const Model& model, const std::string& extension)
{
    const TemporaryFolder folder;
    write_model(model, folder.file("model" + extension));
    return read_model(folder.file("model" + extension));
}

// Faces as positions, each polygon from its smallest corner on: what must survive any format
// that keeps polygons, whatever becomes of the vertices' numbers.
std::vector<std::vector<std::array<float, 3>>> polygons(const Mesh& mesh)
{
    std::vector<std::vector<std::array<float, 3>>> faces;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::vector<std::array<float, 3>> face;
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const glm::vec3 p = mesh.positions[mesh.corners[c]] + 0.0f;
            face.push_back({p.x, p.y, p.z});
        }
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.push_back(std::move(face));
    }
    return faces;
}

Model transformed_sphere()
{
    Mesh sphere = sphere_mesh(0.3, 17, 9);
    for (std::size_t v = 0; v < sphere.vertex_count(); ++v)
        sphere.colors.emplace_back(0.5f + sphere.positions[v], 1);
    return single_mesh_model("ball", std::move(sphere));
}

class PolygonFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(PolygonFormats, KeepEveryPolygonToTheLastBit)
{
    for (const Model& model : {box_model(), transformed_sphere()}) {
        const Model back = through_file(model, GetParam());
        ASSERT_EQ(back.meshes.size(), 1u);
        EXPECT_EQ(polygons(*back.meshes[0]), polygons(*model.meshes[0]));
        EXPECT_TRUE(back.notices.empty()) << back.notices[0];
    }
}
INSTANTIATE_TEST_SUITE_P(Formats, PolygonFormats, ::testing::Values(".obj", ".ply", ".off"));

class AllFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(AllFormats, KeepSurfaceAndSeams)
{
    const Model model = transformed_sphere();
    const Model back = through_file(model, GetParam());
    const Mesh& mesh = *back.meshes.at(0);
    EXPECT_EQ(triangles(mesh).size(), triangles(*model.meshes[0]).size());
    EXPECT_EQ(point_count(mesh), point_count(*model.meshes[0]));
    const Box box = bounding_box(back), expected = bounding_box(model);
    EXPECT_LT(glm::distance(box.lo, expected.lo) + glm::distance(box.hi, expected.hi), 1e-6);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        EXPECT_GT(glm::dot(mesh.normals[v], glm::normalize(mesh.positions[v])), 0.9f);
}

TEST_P(AllFormats, PlaceNodesWhereTheyAre)
{
    Model model = transformed_sphere();
    model.nodes.push_back({"second", 0, glm::translate(glm::dmat4(1), {5, 0, 0}), 0});
    model.nodes[0].to_parent =
        glm::rotate(glm::translate(glm::dmat4(1), {1, 2, 3}), 0.5, glm::dvec3(0, 0, 1));
    const Box expected = bounding_box(model), box = bounding_box(through_file(model, GetParam()));
    EXPECT_LT(glm::distance(box.lo, expected.lo) + glm::distance(box.hi, expected.hi), 1e-5);
}

TEST_P(AllFormats, LeaveThePreviousFileWhereTheFolderIsReadOnly)
{
    const TemporaryFolder folder;
    const std::string path = folder.file(std::string("model") + GetParam());
    write_model(box_model(), path);
    const std::string before = file_hash(path);
    // A file where a folder should be fails for everybody, the superuser too.
    EXPECT_THROW(write_model(box_model(), path + "/model" + GetParam()), Rejected);
    EXPECT_EQ(file_hash(path), before);
    EXPECT_THROW(write_model(box_model(), folder.file(std::string("none/model") + GetParam())),
                 Rejected);
}
INSTANTIATE_TEST_SUITE_P(Formats, AllFormats,
                         ::testing::Values(".obj", ".ply", ".stl", ".off", ".glb"));

TEST(Writing, SaysThatTheDiskIsFull)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TemporaryFolder folder;
    // The temporary file lies beside the target, so a target on the full device cannot be made.
    EXPECT_THROW(write_model(box_model(), "/dev/full/model.glb"), Rejected);
    EXPECT_THROW(write_model(box_model(), folder.file("model.fbx")), Rejected);
}

TEST(Obj, KeepsMaterialsGroupsNormalsAndTextureCoordinates)
{
    const Model model = box_model(), back = through_file(model, ".obj");
    const Mesh &a = *model.meshes[0], &b = *back.meshes[0];
    EXPECT_EQ(b.group_names, a.group_names);
    EXPECT_EQ(b.face_group, a.face_group);
    EXPECT_EQ(b.face_material, a.face_material);
    ASSERT_EQ(b.corners.size(), a.corners.size());
    for (std::size_t c = 0; c < a.corners.size(); ++c) {
        EXPECT_EQ(b.normals[b.corners[c]], a.normals[a.corners[c]]);
        EXPECT_EQ(b.uvs[0][b.corners[c]], a.uvs[0][a.corners[c]]);
    }
    EXPECT_TRUE(back.notices.empty()) << back.notices[0];
    ASSERT_EQ(back.materials.size(), 2u);
    ASSERT_TRUE(back.materials[0].base_color_texture.image);
    for (std::size_t m = 0; m < 2; ++m) {
        EXPECT_EQ(back.materials[m].name, model.materials[m].name);
        EXPECT_EQ(back.materials[m].base_color, model.materials[m].base_color);
        EXPECT_EQ(back.materials[m].roughness, model.materials[m].roughness);
        EXPECT_EQ(back.materials[m].metallic, model.materials[m].metallic);
    }
    EXPECT_EQ(back.materials[0].base_color_texture.image->rgba, checker_image().rgba);
}

TEST(Ply, KeepsColoursToTheNearestOf256)
{
    const Model model = transformed_sphere(), back = through_file(model, ".ply");
    const Mesh &a = *model.meshes[0], &b = *back.meshes[0];
    ASSERT_EQ(b.colors.size(), a.colors.size());
    for (std::size_t v = 0; v < a.colors.size(); ++v)
        EXPECT_LT(glm::distance(a.colors[v], b.colors[v]), 0.012f);
}

TEST(Glb, KeepsNodesMaterialsTexturesTangentsAndSeveralTextureCoordinates)
{
    Model model = box_model();
    Mesh mesh = *model.meshes[0];
    mesh.uvs.push_back(mesh.uvs[0]);
    for (glm::vec2& uv : mesh.uvs[1]) uv *= 0.5f;
    mesh.tangents.assign(mesh.vertex_count(), glm::vec4(0.6f, 0, 0.8f, -1));
    mesh.colors.assign(mesh.vertex_count(), glm::vec4(0.25f, 0.5f, 1, 1));
    model.meshes[0] = make_ref(mesh);
    model.materials[0].emissive = {0, 4, 2};
    model.materials[0].base_color_texture.repeat_u = false;
    model.materials[0].base_color_texture.uv_set = 1;
    model.materials[1].double_sided = true;
    model.materials[1].alpha = Material::Alpha::mask;
    model.materials[1].alpha_cutoff = 0.3f;
    model.nodes.push_back({"child", 0, glm::scale(glm::dmat4(1), {2, 1, 1}), 0});

    const Model back = through_file(model, ".glb");
    ASSERT_EQ(back.nodes.size(), 2u);
    for (std::size_t n = 0; n < 2; ++n) {
        EXPECT_EQ(back.nodes[n].name, model.nodes[n].name);
        EXPECT_EQ(back.nodes[n].parent, model.nodes[n].parent);
        EXPECT_EQ(back.nodes[n].to_parent, model.nodes[n].to_parent);
    }
    ASSERT_EQ(back.meshes.size(), 1u) << "two nodes share one mesh";
    const Mesh& b = *back.meshes[0];
    EXPECT_EQ(b.positions, mesh.positions);
    EXPECT_EQ(b.normals, mesh.normals);
    EXPECT_EQ(b.colors, mesh.colors);
    EXPECT_EQ(b.tangents, mesh.tangents);
    EXPECT_EQ(b.points, mesh.points);
    EXPECT_EQ(b.uvs, mesh.uvs); // halves and quarters, so that 1 - v is exact
    for (std::size_t m = 0; m < 2; ++m) {
        Material got = back.materials[m], expected = model.materials[m];
        EXPECT_EQ(got.base_color_texture.image != nullptr, m == 0);
        if (m == 0) {
            EXPECT_EQ(got.base_color_texture.image->rgba, checker_image().rgba);
        }
        got.base_color_texture.image = expected.base_color_texture.image = nullptr;
        EXPECT_EQ(got, expected);
    }
}

TEST(Images, SurviveBeingWrittenAndReadWithoutLoss)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.exr", "a.tif"}) {
        write_image(checker_image(), folder.file(name));
        const Image back = read_image(folder.file(name));
        EXPECT_EQ(back.size_px, glm::ivec2(4, 2)) << name;
        EXPECT_EQ(back.rgba, checker_image().rgba) << name;
    }
    EXPECT_THROW(write_image(checker_image(), folder.file("a.nothing")), Rejected);
}

TEST(Reading, FollowsTheUpAxisAndTheScale)
{
    const std::string obj = "v 0 1 0\nv 1 2 0\nv 0 2 5\nf 1 2 3\n";
    const auto first = [&](ReadOptions options) {
        return read_model_bytes(obj, "a.obj", "", options).meshes[0]->positions[1];
    };
    EXPECT_EQ(first({}), glm::vec3(1, 0, 2));
    EXPECT_EQ(first({UpAxis::z, 1}), glm::vec3(1, 2, 0));
    EXPECT_EQ(first({UpAxis::z, 100}), glm::vec3(100, 200, 0));
    EXPECT_THROW(first({UpAxis::z, 0}), Rejected);
    EXPECT_THROW(first({UpAxis::z, 1, true, 10}), Rejected);
}

TEST(Reading, CanBeCancelledAtEveryReport)
{
    const Model model = transformed_sphere();
    for (const char* extension : {".obj", ".ply", ".stl", ".off", ".glb"}) {
        const std::string bytes = bytes_of(model, extension);
        int reports = 0;
        const std::string name = std::string("a") + extension;
        read_model_bytes(bytes, name, "", {}, [&](double, std::string_view) { ++reports; });
        EXPECT_GE(reports, 3) << extension;
        for (int stop = 1; stop <= reports; ++stop) {
            int seen = 0;
            EXPECT_THROW(read_model_bytes(bytes, name, "", {},
                                          [&](double fraction, std::string_view) {
                                              EXPECT_GE(fraction, 0);
                                              EXPECT_LE(fraction, 1);
                                              if (++seen == stop) throw Cancelled();
                                          }),
                         Cancelled);
        }
    }
}

} // namespace
} // namespace trivar

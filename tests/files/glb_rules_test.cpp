// SPDX-License-Identifier: GPL-3.0-or-later
// What Khronos's validator and other programs ask of a GLB, whatever the model holds.
#include "core/files/file_bytes.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/write_model.h"
#include "tests/files/gltf_texts.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace trivar {
namespace {

using namespace testing;

GltfText json_of(const std::string& glb)
{
    return GltfText::parse(glb_chunks(glb).json);
}

// Whether no primitive has a material with a texture whose coordinates its vertices lack.
void expect_coordinates_for_textures(const GltfText& json)
{
    for (const GltfText& mesh : json["meshes"])
        for (const GltfText& primitive : mesh["primitives"]) {
            if (!primitive.contains("material")) continue;
            const std::string set = "TEXCOORD_0";
            const std::string material = json["materials"][primitive["material"].get<int>()].dump();
            EXPECT_TRUE(material.find("Texture") == material.npos ||
                        primitive["attributes"].contains(set))
                << material;
        }
}

Mesh without_uvs(const Mesh& mesh)
{
    Mesh out = mesh;
    out.uvs.clear();
    return out;
}

TEST(GlbRules, ATextureIsBoundOnlyWhereThereAreItsCoordinates)
{
    Model model = box_model();
    model.meshes.push_back(make_ref(without_uvs(*model.meshes[0])));
    model.nodes.push_back({.name = "bare", .mesh = 1});
    Mesh points;
    points.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    model.curves = {make_ref(Curves{make_ref(points), {0, 3}, {0}})};
    model.nodes.push_back({.name = "line", .curves = 0});
    const GltfText json = json_of(write_glb(model));
    expect_coordinates_for_textures(json);
    // Where they are, it stays; what else the material says stays everywhere.
    const auto material = [&](int mesh) {
        return json["materials"][json["meshes"][mesh]["primitives"][0]["material"].get<int>()];
    };
    EXPECT_TRUE(material(0)["pbrMetallicRoughness"].contains("baseColorTexture"));
    EXPECT_FALSE(material(1)["pbrMetallicRoughness"].contains("baseColorTexture"));
    EXPECT_EQ(material(0)["pbrMetallicRoughness"]["baseColorFactor"],
              material(1)["pbrMetallicRoughness"]["baseColorFactor"]);
    EXPECT_EQ(material(1), material(2));
    expect_coordinates_for_textures(json_of(write_glb(
        read_model_bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl any\nf 1 2 3\n", "a.obj", ""))));
}

TEST(GlbRules, NoAccessorIsInputAndOutputOfAnimations)
{
    Model model = rigged_model();
    for (Clip& clip : model.clips)
        for (Channel& channel : clip.channels)
            if (channel.of == Channel::Of::morph_weights && channel.components == 1)
                channel.values = channel.times_s; // as where something grows evenly
    const GltfText json = json_of(write_glb(model));
    std::set<int> in, out;
    for (const GltfText& animation : json["animations"])
        for (const GltfText& sampler : animation["samplers"]) {
            in.insert(sampler["input"].get<int>());
            out.insert(sampler["output"].get<int>());
        }
    EXPECT_FALSE(in.empty());
    for (const int accessor : in) EXPECT_FALSE(out.contains(accessor)) << accessor;
}

TEST(GlbRules, EveryAccessorHasABufferView)
{
    Model model = rigged_model();
    Mesh mesh = *model.meshes[0];
    const std::vector<glm::vec3> zeros(mesh.vertex_count(), glm::vec3(0));
    mesh.morph_targets = {{zeros, zeros, zeros}};
    model.meshes[0] = make_ref(mesh);
    const std::string glb = write_glb(model);
    for (const GltfText& accessor : json_of(glb)["accessors"])
        EXPECT_TRUE(accessor.contains("bufferView") || accessor.contains("sparse")) << accessor;
    EXPECT_EQ(read_model_bytes(glb, "a.glb", "").meshes[0]->morph_targets[0], Mesh::MorphTarget());
}

TEST(GlbRules, TangentsAreUnitWhateverTheFileHad)
{
    Model model = rigged_model();
    model.clips.clear();
    Mesh mesh = *model.meshes[0];
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v)
        mesh.tangents[v] = glm::vec4(glm::vec3(mesh.tangents[v]) * float(v), 1);
    model.meshes[0] = make_ref(mesh);
    const Model read = read_model_bytes(write_glb(model), "a.glb", "");
    ASSERT_FALSE(read.meshes[0]->tangents.empty());
    for (const glm::vec4& t : read.meshes[0]->tangents)
        EXPECT_NEAR(glm::length(glm::vec3(t)), 1, 1e-5);
    // The tangents of a mesh without normals belong to normals that nobody knows.
    mesh.normals.clear();
    model.meshes[0] = make_ref(mesh);
    EXPECT_TRUE(read_model_bytes(write_glb(model), "a.glb", "").meshes[0]->tangents.empty());
}

TEST(GlbRules, ACameraLooksFromItsNode)
{
    Model model = box_model();
    const Camera camera{.eye = {4, -6, 3}, .target = {1, 0, 0}, .size_px = {1600, 900}};
    model.cameras = {camera};
    model.nodes.push_back(
        {.name = "eye", .to_parent = glm::inverse(view_matrix(camera)), .camera = 0});
    const GltfText json = json_of(write_glb(model));
    ASSERT_EQ(json["cameras"].size(), 1u);
    EXPECT_NEAR(json["cameras"][0]["perspective"]["yfov"].get<double>(), camera.fov_y, 1e-9);
    EXPECT_NEAR(json["cameras"][0]["perspective"]["aspectRatio"].get<double>(), 16.0 / 9, 1e-9);
    const GltfText& node = json["nodes"].back();
    EXPECT_EQ(node["camera"], 0);
    const auto number = [&](int i) { return node["matrix"][i].get<double>(); };
    // In glTF's world Y is up: (4, 3, 6), looking along -Z to (1, 0, 0).
    EXPECT_NEAR(number(12), 4, 1e-9);
    EXPECT_NEAR(number(13), 3, 1e-9);
    EXPECT_NEAR(number(14), 6, 1e-9);
    const glm::dvec3 along = glm::normalize(glm::dvec3(1, 0, 0) - glm::dvec3(4, 3, 6));
    EXPECT_LT(glm::distance(-glm::dvec3(number(8), number(9), number(10)), along), 1e-9);
}

TEST(ObjNames, KeepBlanksInMaterialsAndTheNamesOfPictures)
{
    const TemporaryFolder from, to;
    write_file(from.path() / "my wall.png", encoded_image(checker_image(), ".png"));
    write_file(from.path() / "a.mtl", "newmtl Low Vegetation\nmap_Kd my wall.png\n");
    write_file(from.path() / "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                                      "vt 0 1\nusemtl Low Vegetation\nf 1/1 2/2 3/3\n");
    const Model model = read_model(from.file("a.obj"));
    ASSERT_TRUE(model.materials[0].base_color_texture.image);
    write_model(model, to.file("r.obj"));
    EXPECT_TRUE(std::filesystem::exists(to.path() / "my wall.png"));
    const Model again = read_model(to.file("r.obj"));
    EXPECT_EQ(again.materials[0].name, "Low Vegetation");
    EXPECT_EQ(again.materials[0].base_color_texture.image->rgba,
              model.materials[0].base_color_texture.image->rgba);
    // Beside its source the picture is there already, and another one of that name stays.
    SourceFiles sources;
    sources.add(from.file("my wall.png"));
    write_model(model, from.file("r.obj"), sources);
    EXPECT_FALSE(std::filesystem::exists(from.path() / "r_0.png"));
    write_file(to.path() / "my wall.png", "another one");
    write_model(model, to.file("r.obj"));
    EXPECT_EQ(read_bytes(to.file("my wall.png"), 100), "another one");
    EXPECT_TRUE(std::filesystem::exists(to.path() / "r_0.png"));
}

TEST(ObjNames, OfPicturesThatNoLineCanHoldAreOthers)
{
    for (const char* name : {"", "-bm.png", "a#b.png", "a\nb.png", ".png", " a.png", "a.png\\"}) {
        Model model = box_model();
        Image image = checker_image();
        image.source_bytes = encoded_image(image, ".png");
        image.mime = "image/png";
        image.name = name;
        model.materials[0].base_color_texture.image = make_ref(image);
        EXPECT_EQ(write_obj(model, "m").images.at(0).first, "m_0.png") << name;
    }
}

} // namespace
} // namespace trivar

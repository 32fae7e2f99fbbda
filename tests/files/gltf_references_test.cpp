// SPDX-License-Identifier: GPL-3.0-or-later
// What a glTF file names and cannot be had is said once, with how often; the rest is read.
#include "core/files/gltf/gltf_uri.h"
#include "tests/files/gltf_texts.h"
#include "tests/fuzz/sound_pictures.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::AllOf, ::testing::ElementsAre, ::testing::EndsWith, ::testing::HasSubstr,
    ::testing::IsEmpty;

// The file with two more materials of the same kind as its first one.
GltfText three_materials(GltfText text)
{
    text["materials"] = {text["materials"][0], text["materials"][0], text["materials"][0]};
    return text;
}

TEST(GltfReferences, ToTexturesPicturesAndSamplersThatAreNotThereAreCounted)
{
    EXPECT_THAT(read_gltf_text(textured_gltf()).notices, IsEmpty());
    GltfText text = three_materials(textured_gltf());
    for (GltfText& material : text["materials"])
        material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7;
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre("a.gltf: 3 textures that materials name do not exist"));
    text = textured_gltf();
    text["textures"][0]["source"] = 4;
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre(HasSubstr("one texture names a picture")));
    text = textured_gltf();
    text["textures"][0]["sampler"] = 4;
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre(HasSubstr("one texture names a sampler")));
    text = textured_gltf();
    text["images"][0].erase("uri");
    EXPECT_THAT(read_gltf_text(text).notices, ElementsAre("a.gltf: image 0: it has neither a 'uri' "
                                                          "nor a 'bufferView'"));
    text = textured_gltf();
    text["meshes"][0]["primitives"][0]["material"] = 9;
    EXPECT_THAT(read_gltf_text(text).notices, ElementsAre(HasSubstr("names a material")));
}

TEST(GltfReferences, ToPicturesInExtensionsAreReadWhereTheyCanBe)
{
    GltfText text = textured_gltf();
    text["extensionsUsed"] = {"EXT_texture_webp"};
    text["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    const Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices, IsEmpty());
    EXPECT_TRUE(model.materials[0].base_color_texture.image);
    text["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre(HasSubstr("only in a kind that cannot be read, KHR_texture_basisu")));
    text["textures"][0]["source"] = 0; // a plain picture beside it
    EXPECT_THAT(read_gltf_text(text).notices, IsEmpty());
}

TEST(GltfReferences, ToOptionalExtensionsAreSaidOnce)
{
    GltfText text = triangle_gltf();
    text["extensionsUsed"] = {"KHR_materials_ior", "KHR_mesh_quantization", "KHR_lights_punctual"};
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre("a.gltf: 2 of its extensions are not supported and were left out: "
                            "KHR_materials_ior, KHR_lights_punctual"));
    text["extensionsRequired"] = {"KHR_lights_punctual", "KHR_materials_ior"}; // change no shape
    EXPECT_EQ(read_gltf_text(text).notices.size(), 1u);
    text["extensionsRequired"] = {"KHR_lights_punctual", "EXT_meshopt_compression"};
    EXPECT_THAT(gltf_refusal(text), HasSubstr("it needs the extension EXT_meshopt_compression"));
}

TEST(GltfReferences, TransformsOfTexturesMoveTheCoordinatesOfTheirOwnFaces)
{
    GltfText text = textured_gltf();
    const std::vector<glm::vec2> plain = read_gltf_text(text).meshes[0]->uvs[0];
    text["extensionsUsed"] = text["extensionsRequired"] = {"KHR_texture_transform"};
    text["materials"].push_back(text["materials"][0]);
    GltfText& use = text["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"];
    // A quarter turn counter-clockwise as it is seen: (u, v) becomes (v, -u), for v goes down.
    use["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.5, 0.25}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}};
    GltfText& primitives = text["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]); // the same vertices with the other material
    primitives[1]["material"] = 1;
    const Model model = read_gltf_text(text);
    for (const std::string& each : model.notices) // of the two faces in one place there is one
        EXPECT_EQ(each.find("transform"), each.npos) << each;
    const std::vector<glm::vec2>& uvs = model.meshes[0]->uvs[0];
    ASSERT_EQ(uvs.size(), 6u);
    for (std::size_t v = 0; v < 3; ++v) {
        EXPECT_EQ(uvs[v], plain[v]);
        const glm::vec2 down(plain[v].x, 1 - plain[v].y);
        const glm::vec2 moved(0.5f + 3 * down.y, 0.25f - 2 * down.x);
        EXPECT_NEAR(uvs[v + 3].x, moved.x, 1e-5f);
        EXPECT_NEAR(uvs[v + 3].y, 1 - moved.y, 1e-5f);
    }
}

TEST(GltfReferences, TransformsThatDifferOnTheSameCoordinatesAreSaid)
{
    GltfText text = textured_gltf();
    text["materials"][0]["normalTexture"] = {
        {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre(HasSubstr("the transform of one texture was left out")));
}

TEST(GltfReferences, MirroredTexturesAreReadAsRepeating)
{
    GltfText text = three_materials(textured_gltf());
    text["samplers"][0] = {{"wrapS", 33648}, {"wrapT", 33071}};
    const Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("one texture is mirrored where it repeats")));
    EXPECT_TRUE(model.materials[0].base_color_texture.repeat_u);
    EXPECT_FALSE(model.materials[0].base_color_texture.repeat_v);
}

TEST(GltfReferences, ToFilesThatAreNotInTheFolderAreCountedAndNamed)
{
    const TemporaryFolder folder;
    GltfText text = textured_gltf();
    text["images"] = GltfText::parse(R"([{"uri":"a.png","name":"bark"},{"uri":"b.png"}])");
    text["textures"] = GltfText::parse(R"([{"source":0},{"source":1}])");
    text["materials"][0]["normalTexture"] = {{"index", 1}};
    EXPECT_THAT(read_gltf_text(text, folder.path().string()).notices,
                ElementsAre("a.gltf: 2 pictures are not in its folder, 'a.png' for one"));
    text["buffers"][0]["uri"] = "body one.bin";
    EXPECT_THAT(gltf_refusal(text),
                EndsWith("bufferView 0, buffer 0: its file 'body one.bin' is not "
                         "in the folder of the glTF file"));
    const std::string uri = triangle_gltf()["buffers"][0]["uri"];
    write_file(folder.path() / "body one.bin", data_uri_bytes(uri).value());
    text["buffers"][0]["uri"] = "body%20one.bin";
    EXPECT_NO_THROW(read_gltf_text(text, folder.path().string()));
}

TEST(GltfPictures, AreDecodedOnceHoweverManyShareThem)
{
    const TemporaryFolder folder;
    write_image(checker_image(), folder.file("a.png"));
    const std::string png = encoded_image(checker_image(), ".png");
    GltfText text = textured_gltf();
    text["buffers"].push_back({{"byteLength", png.size()}, {"uri", data_uri(png)}});
    text["bufferViews"].push_back({{"buffer", 1}, {"byteLength", png.size()}});
    text["bufferViews"].push_back({{"buffer", 1}, {"byteLength", png.size()}});
    text["images"] = GltfText::parse(R"([{"bufferView":1},{"bufferView":2},{"uri":"a.png"},
                                         {"uri":"a.png"}])");
    text["textures"] = GltfText::parse(R"([{"source":0},{"source":1},{"source":2},{"source":3}])");
    text["materials"][0]["normalTexture"] = {{"index", 1}};
    text["materials"][0]["occlusionTexture"] = {{"index", 2}};
    text["materials"][0]["emissiveTexture"] = {{"index", 3}};
    const Material m = read_gltf_text(text, folder.path().string()).materials[0];
    ASSERT_TRUE(m.base_color_texture.image && m.occlusion_texture.image);
    EXPECT_EQ(m.normal_texture.image, m.base_color_texture.image);
    EXPECT_EQ(m.emissive_texture.image, m.occlusion_texture.image);
}

TEST(GltfPictures, AreLeftOutBeforeTheyFillTheMemory)
{
    // A header that declares 2^28 pixels, and bytes enough for it to be believed alone.
    const std::string head = "IHDR" + big(16384, 4) + big(16384, 4) + std::string("\1\0\0\0\0", 5);
    std::string picture = "\x89PNG\r\n\x1a\n" + big(13, 4) + head + big(png_checksum(head), 4);
    picture.resize(300'000, '\1');
    GltfText text = three_materials(textured_gltf());
    text["images"][0] = {{"uri", data_uri(picture)}, {"name", "sky"}};
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre(AllOf(HasSubstr("the picture 'sky' was left out"),
                                  EndsWith("too many pixels for the size of the file"))));
}

} // namespace
} // namespace trivar

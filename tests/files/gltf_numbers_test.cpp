// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of glTF files that are none, are beyond use, or are not in the file at all.
#include "tests/files/gltf_texts.h"

#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

using namespace testing;
using ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;

constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

// The triangle's file with other numbers in its buffer: three positions, three texture coordinates.
GltfText with_numbers(const std::vector<float>& numbers)
{
    GltfText text = triangle_gltf();
    const std::string bytes(reinterpret_cast<const char*>(numbers.data()), 60);
    text["buffers"][0]["uri"] = data_uri(bytes);
    return text;
}

TEST(GltfNumbers, OfAnAccessorInNoBufferAreZeros)
{
    GltfText text = triangle_gltf();
    text["accessors"][1] = {{"componentType", 5126}, {"count", 3}, {"type", "VEC2"}};
    const Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices, IsEmpty());
    EXPECT_EQ(model.meshes[0]->uvs.at(0), std::vector<glm::vec2>(3, glm::vec2(0, 1)));
    // Two of three are given: those of the positions' buffer.
    text["accessors"][1]["sparse"] = GltfText::parse(
        R"({"count":2,"indices":{"bufferView":1,"componentType":5121},
            "values":{"bufferView":0,"byteOffset":12}})");
    text["buffers"].push_back({{"byteLength", 2}, {"uri", data_uri(std::string("\0\2", 2))}});
    text["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 2}});
    EXPECT_EQ(read_gltf_text(text).meshes[0]->uvs.at(0),
              (std::vector<glm::vec2>{{1, 1}, {0, 1}, {0, 1}}));
}

TEST(GltfNumbers, OfAnAccessorInNoBufferAreBounded)
{
    GltfText text = triangle_gltf();
    text["accessors"][0] = {{"componentType", 5126}, {"count", 4'000'000'000}, {"type", "VEC3"}};
    EXPECT_THAT(gltf_refusal(text), HasSubstr("can hold"));
}

TEST(GltfNumbers, OfPositionsMustBeFiniteAndOthersAreReadAsZero)
{
    EXPECT_THAT(gltf_refusal(with_numbers({0, 0, no_number, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1})),
                HasSubstr("'POSITION' has values that are not finite numbers, 1 in all"));
    const Model model =
        read_gltf_text(with_numbers({0, 0, 0, 1, 0, 0, 0, 1, 0, no_number, 0, 1, no_number, 0, 1}));
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("2 values of its vertices are not finite")));
    EXPECT_EQ(model.meshes[0]->uvs.at(0)[0], glm::vec2(0, 1));
}

TEST(GltfNumbers, ThatPutAMeshOutOfReachAreRefused)
{
    EXPECT_THAT(gltf_refusal(with_numbers({0, 0, 0, 3e38f, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1})),
                HasSubstr("a mesh reaches 3·10³⁸ m from the origin, but coordinates up to "
                          "1,000,000,000,000,000 m"));
    GltfText text = triangle_gltf();
    text["nodes"][0]["scale"] = {1e30, 1, 1};
    EXPECT_THAT(gltf_refusal(text), HasSubstr("node 0: 'scale' has the number 1·10³⁰"));
    text["nodes"] = GltfText::parse(R"([{"children":[1],"scale":[1e9,1,1]},
                                        {"mesh":0,"name":"far","scale":[1e9,1,1]}])");
    EXPECT_THAT(gltf_refusal(text), HasSubstr("the mesh of node 'far' reaches 1·10¹⁸ m"));
}

TEST(GltfNumbers, OfASkinThatPutItsMeshOutOfReachLeaveTheSkinOut)
{
    Model model = rigged_model();
    for (const double number : {1e30, double(no_number)}) {
        model.skins[0].mesh_to_joint[0][3][1] = number;
        const Model back = read_model_bytes(bytes_of(model, ".glb"), "a.glb", "");
        EXPECT_EQ(back.nodes[0].skin, -1) << number;
        EXPECT_THAT(back.notices, Contains(HasSubstr("one skin"))) << number;
    }
}

TEST(GltfNumbers, OfATrackThatAreBeyondUseLeaveItOut)
{
    for (const float number : {1e30f, no_number}) {
        Model model = rigged_model();
        model.clips[1].channels[0].values.back() = number;
        const Model back = read_model_bytes(gltf_text(model), "a.gltf", "");
        EXPECT_EQ(back.clips.size(), 1u);
        EXPECT_THAT(back.notices, Contains(HasSubstr("values that are beyond 1e15 or not finite")));
    }
}

TEST(GltfNumbers, OfAVertexesSharesThatAreNoneCountAsNone)
{
    Model model = rigged_model();
    Mesh mesh = *model.meshes[0];
    for (Mesh::Influences& by : mesh.influences) {
        by.joints = {0, 1, 0, 0};
        by.weights = {no_number, 1, 0, 0};
    }
    model.meshes[0] = make_ref(mesh);
    const Model back = read_model_bytes(gltf_text(model), "a.gltf", "");
    EXPECT_THAT(back.notices, Contains(HasSubstr("values of its vertices are not finite")));
    EXPECT_EQ(back.meshes[0]->influences[0].joints[0], 1);
    EXPECT_EQ(back.meshes[0]->influences[0].weights, glm::vec4(1, 0, 0, 0));
}

TEST(GltfNumbers, OfMorphTargetsInNoBufferAreNoDifferences)
{
    Model model = rigged_model();
    model.clips.clear();
    Mesh mesh = *model.meshes[0];
    const std::vector<glm::vec3> zeros(mesh.vertex_count(), glm::vec3(0));
    mesh.morph_targets = {{mesh.normals, zeros, zeros}, {zeros, zeros, zeros}};
    model.meshes[0] = make_ref(mesh);
    const Model back = read_model_bytes(bytes_of(model, ".glb"), "a.glb", "");
    EXPECT_THAT(back.notices, IsEmpty());
    ASSERT_EQ(back.meshes[0]->morph_targets.size(), 2u);
    EXPECT_EQ(back.meshes[0]->morph_targets[0].positions, mesh.normals);
    EXPECT_TRUE(back.meshes[0]->morph_targets[0].normals.empty());
    EXPECT_EQ(back.meshes[0]->morph_targets[1], Mesh::MorphTarget());
}

} // namespace
} // namespace trivar

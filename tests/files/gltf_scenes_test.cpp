// SPDX-License-Identifier: GPL-3.0-or-later
// What of a glTF file is shown: one scene, and something whatever the scene says.
#include "core/mesh/pose.h"
#include "tests/files/gltf_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;

GltfText two_scenes()
{
    GltfText text = triangle_gltf();
    text["nodes"] = GltfText::parse(R"([{"mesh":0},{"mesh":0,"scale":[7,7,7]}])");
    text["scenes"] = GltfText::parse(R"([{"nodes":[0]},{"nodes":[1]}])");
    return text;
}

TEST(GltfScenes, OfSeveralTheOneToBeShownIsReadAndSaid)
{
    GltfText text = two_scenes();
    text["scene"] = 1;
    Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("of its 2 scenes only number 2 was read")));
    EXPECT_EQ(bounding_box(model).size().x, 7);
    text.erase("scene");
    model = read_gltf_text(text);
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("of its 2 scenes only the first was read")));
    EXPECT_EQ(bounding_box(model).size().x, 1);
    text["scene"] = 5;
    EXPECT_THAT(read_gltf_text(text).notices,
                ElementsAre(HasSubstr("5, does not exist: the first")));
}

TEST(GltfScenes, ThatShowNothingLeaveAllNodesToBeRead)
{
    GltfText text = two_scenes();
    text["scenes"] = {GltfText::object()};
    text["scene"] = 0;
    const Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("its scene shows no mesh")));
    EXPECT_EQ(model.nodes.size(), 2u);
}

TEST(GltfScenes, MeshesWithoutAnyNodeAreShownAsIfEachHadOne)
{
    GltfText text = triangle_gltf();
    text["meshes"].push_back(text["meshes"][0]);
    text["meshes"][1]["name"] = "second";
    for (const char* part : {"nodes", "scenes", "scene"}) text.erase(part);
    const Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("any of its 2 meshes")));
    ASSERT_EQ(model.nodes.size(), 2u);
    EXPECT_EQ(model.nodes[1].name, "second");
    EXPECT_EQ(bounding_box(model).size(), glm::dvec3(1, 0, 1));
}

TEST(GltfScenes, MeshesThatNoNodeOfTheSceneNamesAreLeftOutAndCounted)
{
    GltfText text = triangle_gltf();
    text["meshes"] = {text["meshes"][0], text["meshes"][0], text["meshes"][0]};
    text["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 99; // nobody asks for it
    text["nodes"][0]["mesh"] = 1;
    const Model model = read_gltf_text(text);
    EXPECT_THAT(model.notices,
                ElementsAre("a.gltf: 2 meshes belong to no node of the scene and were left out"));
    EXPECT_EQ(model.meshes.size(), 1u);
    EXPECT_EQ(model.nodes[0].mesh, 0);
}

TEST(GltfScenes, BuffersThatNothingAsksForNeedNotBeThere)
{
    GltfText text = triangle_gltf();
    text["buffers"].push_back({{"byteLength", 100}});
    text["buffers"].push_back({{"byteLength", 3}, {"uri", "data:,abc"}});
    EXPECT_THAT(read_gltf_text(text).notices, IsEmpty());
    text["bufferViews"][0]["buffer"] = 1;
    EXPECT_THAT(gltf_refusal(text), HasSubstr("buffer 1: it has no 'uri'"));
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a glTF file is said with its place, and with what would be right.
#include "tests/files/gltf_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::AllOf, ::testing::HasSubstr, ::testing::Not, ::testing::StartsWith;

TEST(GltfSentences, NameThePlaceWhatStandsThereAndWhatShould)
{
    GltfText text = GltfText::parse(gltf_text(rigged_model()));
    text["animations"][0]["channels"][0].erase("sampler");
    EXPECT_EQ(gltf_refusal(text), "a.gltf: animation 0 'bend', channel 0: 'sampler' is missing and "
                                  "must be a whole number from 0 up");
    text["animations"][0]["channels"][0]["sampler"] = "first";
    EXPECT_EQ(gltf_refusal(text), "a.gltf: animation 0 'bend', channel 0: 'sampler' is the text "
                                  "'first', but must be a whole number from 0 up");
    text["animations"][0]["channels"][0]["sampler"] = 7;
    EXPECT_THAT(gltf_refusal(text), HasSubstr("channel 0: 'sampler' names sampler 7"));
}

TEST(GltfSentences, TellWhichAttributeAnAccessorIsReadFor)
{
    GltfText text = triangle_gltf();
    text["accessors"][1]["count"] = 300;
    EXPECT_EQ(gltf_refusal(text),
              "a.gltf: mesh 0, primitive 0, attributes, TEXCOORD_0 (accessor 1): its 300 elements "
              "of 8 bytes reach past the end of its buffer view, which has 60 bytes");
    text["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 5;
    EXPECT_THAT(gltf_refusal(text), HasSubstr("attributes: 'TEXCOORD_0' names accessor 5, which is "
                                              "not there: the last is accessor 1"));
}

TEST(GltfSentences, GiveTheLineWhereJsonIsDamaged)
{
    EXPECT_EQ(gltf_refusal("{\"asset\":\n{\"version\" \"2.0\"}}", "a.gltf"),
              "a.gltf: its JSON is damaged in line 2, near character 16");
    EXPECT_THAT(gltf_refusal("{\"asset\":", "a.gltf"), HasSubstr("cut off"));
    EXPECT_THAT(gltf_refusal("[]", "a.gltf"), HasSubstr("must be an object"));
    EXPECT_THAT(gltf_refusal("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}", "a.gltf"),
                HasSubstr("too large"));
}

TEST(GltfSentences, NeverPrintADataUri)
{
    GltfText text = textured_gltf();
    text["images"][0]["uri"] = "data:image/png;base64,$$$$" + std::string(1000, 'x');
    const Model model = read_gltf_text(text);
    ASSERT_EQ(model.notices.size(), 1u);
    EXPECT_EQ(model.notices[0], "a.gltf: picture 0: its data uri is not base64");
    text = triangle_gltf();
    text["buffers"][0]["uri"] = "data:application/octet-stream;base64,A";
    EXPECT_THAT(gltf_refusal(text),
                AllOf(HasSubstr("buffer 0: the text of its data uri is not base64"),
                      Not(HasSubstr("octet"))));
}

TEST(GltfSentences, CutTheNamesOfFilesThatAreEndless)
{
    const std::string endless(3000, 'A');
    GltfText text = triangle_gltf();
    text["buffers"][0]["uri"] = endless;
    EXPECT_LT(gltf_refusal(text).size(), 400u);
    text = textured_gltf();
    text["images"][0]["uri"] = endless;
    const Model model = read_gltf_text(text);
    ASSERT_EQ(model.notices.size(), 1u);
    EXPECT_LT(model.notices[0].size(), 400u);
}

TEST(GltfSentences, SayWhyThereAreNoFaces)
{
    GltfText text = triangle_gltf();
    text["meshes"][0]["primitives"][0]["mode"] = 0;
    EXPECT_THAT(gltf_refusal(text),
                StartsWith("a.gltf: it is a point cloud, which is not shown; make a mesh of"));
    text["meshes"][0]["primitives"].push_back({{"attributes", {{"NORMAL", 0}}}});
    EXPECT_EQ(gltf_refusal(text), "a.gltf: it has no faces and no lines: one part of a mesh is "
                                  "points and was left out; one part of a mesh has no positions "
                                  "and was left out");
}

// Whatever stands anywhere in the JSON.
TEST(GltfSentences, AreWholeForEveryValueOfEveryWrongType)
{
    GltfText text = GltfText::parse(gltf_text(rigged_model()));
    const GltfText textured = textured_gltf();
    for (const char* list : {"materials", "textures", "samplers", "images"})
        text[list] = textured[list];
    text["meshes"][0]["primitives"][0]["material"] = 0;
    ASSERT_EQ(gltf_refusal(text), "");
    std::vector<std::string> places;
    const std::function<void(const GltfText&, const std::string&)> collect =
        [&](const GltfText& value, const std::string& place) {
            places.push_back(place);
            if (!value.is_structured()) return;
            for (const auto& [key, each] : value.items()) collect(each, place + "/" + key);
        };
    for (const auto& [key, each] : text.items()) collect(each, "/" + key);
    EXPECT_GT(places.size(), 200u);
    for (const std::string& place : places)
        for (const char* value :
             {"null", "true", "-1", "0.5", "1e300", "\"x\"", "[]", "[[0]]", "{}", "4000000000"}) {
            GltfText changed = text;
            changed[GltfText::json_pointer(place)] = GltfText::parse(value);
            const std::string said = gltf_refusal(changed);
            if (said.empty()) continue;
            EXPECT_THAT(said, AllOf(StartsWith("a.gltf: "), Not(HasSubstr("exception"))))
                << place << " as " << value;
            EXPECT_LT(said.size(), 400u) << said;
        }
}

} // namespace
} // namespace trivar

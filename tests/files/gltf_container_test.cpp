// SPDX-License-Identifier: GPL-3.0-or-later
// The chunks of a GLB file.
#include "core/files/gltf/glb_chunks.h"
#include "core/files/gltf/gltf_uri.h"
#include "tests/files/gltf_texts.h"

#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

std::string word(std::size_t value)
{
    const auto number = static_cast<std::uint32_t>(value);
    return {reinterpret_cast<const char*>(&number), 4};
}

std::string chunk(const std::string& kind, std::string data)
{
    data.resize((data.size() + 3) / 4 * 4, kind == "JSON" ? ' ' : '\0');
    return word(data.size()) + kind + data;
}

const std::string bin("BIN\0", 4);

std::string glb(const std::string& chunks)
{
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

// Whose first buffer is the file's binary chunk.
GltfText binary_triangle()
{
    GltfText text = triangle_gltf();
    text["buffers"][0].erase("uri");
    return text;
}

std::string triangle_bytes()
{
    return data_uri_bytes(triangle_gltf()["buffers"][0]["uri"].get<std::string>()).value();
}

TEST(GltfContainer, MayHaveChunksOfOtherKindsAndAnEmptyBinaryOne)
{
    const std::string json = chunk("JSON", binary_triangle().dump());
    EXPECT_EQ(
        gltf_refusal(glb(json + chunk("ABCD", "xyz") + chunk(bin, triangle_bytes())), "a.glb"), "");
    EXPECT_EQ(gltf_refusal(glb(chunk("JSON", triangle_gltf().dump()) + chunk(bin, "")), "a.glb"),
              "");
    EXPECT_THAT(gltf_refusal(glb(json + chunk(bin, "")), "a.glb"),
                HasSubstr("bufferView 0: it reaches to byte 60 of buffer 0, which has 0 bytes"));
}

TEST(GltfContainer, GivesItsBinaryChunkToTheFirstBufferAlone)
{
    GltfText text = binary_triangle();
    EXPECT_THAT(gltf_refusal(glb(chunk("JSON", text.dump())), "a.glb"),
                HasSubstr("buffer 0: it has no 'uri', and only the first buffer"));
    text["buffers"].push_back(text["buffers"][0]);
    text["bufferViews"][0]["buffer"] = 1;
    EXPECT_THAT(
        gltf_refusal(glb(chunk("JSON", text.dump()) + chunk(bin, triangle_bytes())), "a.glb"),
        HasSubstr("buffer 1: it has no 'uri', and only the first buffer"));
}

TEST(GltfContainer, SaysWhatOfItIsCutOff)
{
    const std::string whole =
        glb(chunk("JSON", binary_triangle().dump()) + chunk(bin, triangle_bytes()));
    EXPECT_EQ(gltf_refusal(whole, "a.glb"), "");
    EXPECT_THAT(gltf_refusal(whole.substr(0, whole.size() - 1), "a.glb"), HasSubstr("declares"));
    std::string shorter = whole.substr(0, whole.size() - 4);
    shorter.replace(8, 4, word(shorter.size()));
    EXPECT_THAT(gltf_refusal(shorter, "a.glb"), HasSubstr("its binary chunk is cut off"));
    EXPECT_THAT(gltf_refusal("PK" + whole, "a.glb"), HasSubstr("this is not a GLB file"));
    EXPECT_THAT(gltf_refusal(whole, "a.gltf"), HasSubstr("name it .glb"));
}

TEST(GltfUris, HoldBase64OrText)
{
    EXPECT_EQ(data_uri_bytes("data:application/octet-stream2;base64,YWJj"), "abc");
    EXPECT_EQ(data_uri_bytes("data:;base64,YWI="), "ab");
    EXPECT_EQ(data_uri_bytes("data:;base64,YWI"), "ab");
    EXPECT_EQ(data_uri_bytes("data:text/plain,a%20b%"), "a b%");
    for (const char* wrong : {"data:;base64,Y", "data:;base64,YW$j", "data:;base64,YW=j", "data:x"})
        EXPECT_EQ(data_uri_bytes(wrong), std::nullopt) << wrong;
}

} // namespace
} // namespace trivar

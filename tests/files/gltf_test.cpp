// SPDX-License-Identifier: GPL-3.0-or-later
// What of glTF our own writer never makes. Buffers are data URIs of hand-made bytes.
#include "core/files/read_model.h"
#include "core/mesh/pose.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"

#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::base64, testing::real_data_folder;

template <class T> std::string bytes(std::initializer_list<T> values)
{
    return {reinterpret_cast<const char*>(std::data(values)), values.size() * sizeof(T)};
}

// A file of one mesh; `views` become buffer views 0, 1, ... of one buffer.
Model read(const std::vector<std::string>& views, const std::string& accessors,
           const std::string& primitive, const std::string& rest = R"("nodes":[{"mesh":0}])")
{
    std::string all, list;
    for (const std::string& view : views) {
        list += (list.empty() ? "" : ",") + std::string(R"({"buffer":0,"byteOffset":)") +
                std::to_string(all.size()) + R"(,"byteLength":)" + std::to_string(view.size()) +
                "}";
        all += view;
        all.resize((all.size() + 3) / 4 * 4, '\0');
    }
    const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" +
                             std::to_string(all.size()) +
                             R"(,"uri":"data:application/octet-stream;base64,)" + base64(all) +
                             R"("}],"bufferViews":[)" + list + R"(],"accessors":[)" + accessors +
                             R"(],"meshes":[{"primitives":[)" + primitive + "]}]," + rest + "}";
    return read_model_bytes(text, "made.gltf", "");
}

const std::string square = bytes<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
const std::string four = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";

TEST(Gltf, TurnsStripsAndFansToTrianglesThatAgree)
{
    for (const char* mode : {"5", "6"}) {
        const std::string fan = bytes<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
        const Model model =
            read({mode[0] == '5' ? square : fan}, four,
                 R"({"attributes":{"POSITION":0},"mode":)" + std::string(mode) + "}");
        EXPECT_EQ(model.meshes[0]->face_count(), 2u);
        EXPECT_TRUE(model.notices.empty());
        for (std::size_t f = 0; f < 2; ++f) EXPECT_GT(area_normal(*model.meshes[0], f).z, 0.5);
    }
}

TEST(Gltf, PutsSparseValuesInPlace)
{
    const Model model =
        read({square, bytes<std::uint16_t>({3}), bytes<float>({5, 5, 5})},
             R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,)"
             R"("indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":2}}})",
             R"({"attributes":{"POSITION":0},"mode":5})");
    // Without normals its two triangles are flat, so that two of its points have two vertices.
    const Mesh& mesh = *model.meshes[0];
    ASSERT_EQ(point_count(mesh), 4u);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const auto place = mesh.points[v] == 2   ? glm::vec3(0, 1, 0)
                           : mesh.points[v] == 3 ? glm::vec3(5, 5, 5)
                                                 : mesh.positions[v];
        EXPECT_EQ(mesh.positions[v], place);
    }
}

TEST(Gltf, ReadsNormalisedIntegersAsFractions)
{
    const Model model = read(
        {square, bytes<std::uint16_t>({0, 0, 65535, 0, 0, 65535, 65535, 65535}),
         bytes<std::uint8_t>({255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 255})},
        four +
            R"(,{"bufferView":1,"componentType":5123,"count":4,"type":"VEC2","normalized":true})"
            R"(,{"bufferView":2,"componentType":5121,"count":4,"type":"VEC4","normalized":true})",
        R"({"attributes":{"POSITION":0,"TEXCOORD_0":1,"COLOR_0":2},"mode":5})");
    const Mesh& mesh = *model.meshes[0];
    EXPECT_EQ(mesh.uvs.at(0)[1], glm::vec2(1, 1)) << "v goes up";
    EXPECT_EQ(mesh.uvs.at(0)[2], glm::vec2(0, 0));
    EXPECT_FLOAT_EQ(mesh.colors[0].z, 0.2f);
}

TEST(Gltf, PlacesNodesByTranslationRotationAndScale)
{
    const Model model = read({square}, four, R"({"attributes":{"POSITION":0},"mode":5})",
                             R"("nodes":[{"mesh":0,"translation":[10,0,0],"scale":[2,2,2],)"
                             R"("rotation":[0,0,0.70710678118,0.70710678118]}])");
    // x to y by the rotation, then Y up to Z up.
    const Box box = bounding_box(model);
    EXPECT_LT(glm::distance(box.lo, glm::dvec3(8, 0, 0)), 1e-6);
    EXPECT_LT(glm::distance(box.hi, glm::dvec3(10, 0, 2)), 1e-6);
}

// The counts are those of the folder's own list.
TEST(RealDataMeshes, HaveTheTrianglesTheirSourcesSay)
{
    const std::string folder = real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    const auto count = [&](const std::string& name) {
        return triangles(*read_model(folder + "/meshes/" + name).meshes.at(0)).size();
    };
    EXPECT_EQ(count("stanford-bunny.obj"), 69451u);
    EXPECT_EQ(count("spot.obj"), 5856u);
    EXPECT_EQ(count("mountain.obj"), 50562u);
    EXPECT_EQ(count("face.obj"), 51712u);
    EXPECT_EQ(count("camel.off"), 19536u);
}

} // namespace
} // namespace trivar

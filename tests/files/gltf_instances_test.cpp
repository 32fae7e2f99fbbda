// SPDX-License-Identifier: GPL-3.0-or-later
// EXT_mesh_gpu_instancing, read and written.
#include "core/files/formats.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/mesh/primitives.h"
#include "tests/files/gltf_texts.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;

// The triangle at two places, of which the second is turned by half a turn about Y and twice as
// large. The numbers can be others.
struct Instanced {
    std::vector<float> translations{1, 0, 0, 5, 0, 0}, rotations{0, 0, 0, 1, 0, 1, 0, 0},
        scales{1, 1, 1, 2, 2, 2};
    GltfText text() const
    {
        GltfText out = triangle_gltf();
        std::string bytes;
        GltfText attributes;
        const auto add = [&](const char* name, const std::vector<float>& values, int components) {
            attributes[name] = out["accessors"].size();
            out["accessors"].push_back({{"bufferView", 1},
                                        {"byteOffset", bytes.size()},
                                        {"componentType", 5126},
                                        {"count", values.size() / std::size_t(components)},
                                        {"type", components == 3 ? "VEC3" : "VEC4"}});
            bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * 4);
        };
        add("TRANSLATION", translations, 3);
        add("ROTATION", rotations, 4);
        add("SCALE", scales, 3);
        out["bufferViews"].push_back({{"buffer", 1}, {"byteLength", bytes.size()}});
        out["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", data_uri(bytes)}});
        out["nodes"][0]["name"] = "leaf";
        out["nodes"][0]["translation"] = {0, 7, 0};
        out["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
        out["extensionsUsed"] = out["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        return out;
    }
};

// The corners of all meshes where their nodes stand, as the file has them.
std::vector<glm::dvec3> corners_in_place(const Model& model)
{
    std::vector<glm::dvec3> out;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].mesh < 0) continue;
        const Mesh& mesh = *model.meshes[static_cast<std::size_t>(model.nodes[n].mesh)];
        for (const std::uint32_t v : mesh.corners)
            out.emplace_back(node_to_model(model, static_cast<int>(n)) *
                             glm::dvec4(glm::dvec3(mesh.positions[v]), 1));
    }
    return out;
}

TEST(GltfInstances, BecomeNodesBelowTheOneThatShowsThem)
{
    const Model model = read_gltf_text(Instanced().text());
    EXPECT_THAT(model.notices, IsEmpty());
    ASSERT_EQ(model.nodes.size(), 3u);
    ASSERT_EQ(model.meshes.size(), 1u);
    EXPECT_EQ(model.nodes[0].mesh, -1);
    for (const std::size_t n : {1u, 2u}) {
        EXPECT_EQ(model.nodes[n].parent, 0);
        EXPECT_EQ(model.nodes[n].mesh, 0);
        EXPECT_EQ(model.nodes[n].name, "leaf");
    }
    const std::vector<glm::dvec3> corners = corners_in_place(model);
    // Y up in the file: (x, y, z) is (x, -z, y) here. The first corner is (0, 0, 0), the second
    // (1, 0, 0).
    ASSERT_EQ(corners.size(), 6u);
    EXPECT_LT(glm::distance(corners[0], glm::dvec3(1, 0, 7)), 1e-9);
    EXPECT_LT(glm::distance(corners[1], glm::dvec3(2, 0, 7)), 1e-9);
    EXPECT_LT(glm::distance(corners[3], glm::dvec3(5, 0, 7)), 1e-9);
    EXPECT_LT(glm::distance(corners[4], glm::dvec3(3, 0, 7)), 1e-9);
}

TEST(GltfInstances, NeedNotHaveEveryAttribute)
{
    GltfText text = Instanced().text();
    GltfText& attributes = text["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes.erase("ROTATION");
    attributes.erase("SCALE");
    attributes["_ID"] = 0;
    EXPECT_EQ(read_gltf_text(text).nodes.size(), 3u);
    attributes.erase("TRANSLATION");
    const Model once = read_gltf_text(text);
    EXPECT_EQ(once.nodes.size(), 1u);
    EXPECT_THAT(once.notices, ElementsAre(HasSubstr("instances without places")));
}

TEST(GltfInstances, WithoutATurnAreNotTurned)
{
    Instanced two;
    two.rotations = {0, 0, 0, 0, 0, 0, 0, 3}; // the second is a quaternion of another length
    const Model model = read_gltf_text(two.text());
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("one instance is all zeros")));
    for (const std::size_t n : {1u, 2u})
        EXPECT_EQ(model.nodes[n].rest.rotation, glm::dquat(1, 0, 0, 0));
}

TEST(GltfInstances, OfAMeshWithASkinAreShownOnce)
{
    GltfText text = Instanced().text();
    text["nodes"].push_back(GltfText::object());
    text["skins"] = {{{"joints", {1}}}};
    text["nodes"][0]["skin"] = 0;
    const Model model = read_gltf_text(text);
    EXPECT_EQ(model.nodes[0].mesh, 0);
    EXPECT_THAT(model.notices, ::testing::Contains(HasSubstr("with a skin are shown once")));
}

TEST(GltfInstances, ThatMakeNoSenseAreRefused)
{
    const auto why = [](
                         const std::function<void(Instanced&)>& change,
                         const std::function<void(GltfText&)>& change_text = [](GltfText&) {}) {
        Instanced instanced;
        change(instanced);
        GltfText text = instanced.text();
        change_text(text);
        return gltf_refusal(text);
    };
    const auto as_is = [](Instanced&) {};
    EXPECT_EQ(why(as_is), "");
    EXPECT_THAT(why([](Instanced& i) { i.scales.resize(3); }),
                HasSubstr("'SCALE' places 1 instances, another attribute 2"));
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_THAT(why([&](Instanced& i) { i.rotations[2] = bad; }),
                    HasSubstr("'ROTATION' has a number that is not finite"));
    EXPECT_THAT(why([](Instanced& i) { i.translations[4] = 3e30f; }),
                HasSubstr("numbers up to 1,000,000,000,000,000 are allowed"));
    EXPECT_THAT(why(as_is, [](GltfText& t) { t["accessors"][3]["count"] = 40; }),
                HasSubstr("reach past the end of its buffer view"));
    EXPECT_THAT(why(as_is, [](GltfText& t) { t["accessors"][2]["type"] = "VEC2"; }),
                HasSubstr("'TRANSLATION' has 2 numbers per instance, but must have 3"));
    EXPECT_THAT(why(as_is,
                    [](GltfText& t) {
                        t["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"].erase("attributes");
                    }),
                HasSubstr("attributes"));
    EXPECT_THAT(
        why(as_is,
            [](GltfText& t) {
                t["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = 77;
            }),
        HasSubstr("'SCALE' names accessor 77, which is not there"));
}

TEST(GltfInstances, InHugeNumbersAreRefusedBeforeMemoryIsTaken)
{
    // Accessors without data are zeros, so a small file could ask for any number of them.
    for (const std::size_t count : {std::size_t{2'000'000}, std::size_t{4'000'000'000}}) {
        GltfText text = Instanced().text();
        for (const int a : {2, 3, 4}) {
            text["accessors"][std::size_t(a)]["count"] = count;
            text["accessors"][std::size_t(a)].erase("bufferView");
        }
        EXPECT_THAT(gltf_refusal(text), HasSubstr("more than a file of"));
    }
}

TEST(GltfInstances, OfTooManyVerticesTogetherAreRefused)
{
    Model model = single_mesh_model("ball", sphere_mesh(0.5, 400, 250));
    for (int i = 1; i < 800; ++i) {
        model.nodes.push_back(model.nodes.front());
        model.nodes.back().to_parent[3].x = i;
    }
    EXPECT_THAT(gltf_refusal(write_glb(model, {.instances = true}), "a.glb"),
                HasSubstr("its 800 instances show"));
}

// Twenty balls in a group, one of them turned and stretched, one sheared, one mirrored, and a box
// between them.
Model balls()
{
    Model model = single_mesh_model("group", box_mesh({1, 1, 1}, {1, 1, 1}));
    model.meshes.push_back(make_ref(sphere_mesh(0.5, 12, 6)));
    model.nodes[0].to_parent = glm::translate(glm::dmat4(1), {3, 4, 5});
    for (int i = 0; i < 20; ++i) {
        Node node{.name = "ball", .parent = 0, .mesh = 1};
        node.to_parent = glm::translate(glm::dmat4(1), {1e4 + 2 * i, 0.1 * i, 0});
        if (i == 5)
            node.to_parent = glm::scale(glm::rotate(node.to_parent, 1.0, {1, 2, 3}), {1, 2, 3});
        if (i == 7) node.to_parent[1].x = 0.5;
        if (i == 9) node.to_parent[0].x = -1;
        model.nodes.push_back(node);
        if (i == 12) model.nodes.push_back({.name = "box", .mesh = 0});
    }
    return model;
}

TEST(GltfInstances, OfAWrittenModelComeBackAtTheirPlaces)
{
    const Model model = balls();
    const std::string with = write_glb(model, {.instances = true}), without = write_glb(model);
    EXPECT_LT(with.size(), without.size());
    const GltfText json = GltfText::parse(glb_chunks(with).json);
    EXPECT_EQ(json["extensionsUsed"], json["extensionsRequired"]);
    EXPECT_EQ(json["meshes"].size(), 2u);
    EXPECT_EQ(json["nodes"].size(), 5u); // group, balls, sheared, mirrored, box
    EXPECT_FALSE(GltfText::parse(glb_chunks(without).json).contains("extensionsUsed"));
    const std::vector<glm::dvec3> a = corners_in_place(read_model_bytes(with, "a.glb", "")),
                                  b = corners_in_place(read_model_bytes(without, "a.glb", ""));
    ASSERT_EQ(a.size(), b.size());
    // Ten kilometres away: instances are relative to their middle.
    for (std::size_t i = 0; i < a.size(); i += 11) {
        double nearest = 1e300;
        for (const glm::dvec3& p : b) nearest = std::min(nearest, glm::distance(a[i], p));
        EXPECT_LT(nearest, 1e-5) << i;
    }
}

} // namespace
} // namespace trivar

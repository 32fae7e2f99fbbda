// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/read_model.h"
#include "core/mesh/pose.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;
using testing::gltf_text, testing::real_data_folder, testing::rigged_model;

Model read(const Model& model)
{
    return read_model_bytes(gltf_text(model), "rigged.gltf", "", {.up = UpAxis::z});
}

Mesh posed_at(const Model& model, const Clip* clip, double time_s)
{
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i].mesh < 0) continue;
        const int node = static_cast<int>(i);
        const Stance stance = stance_at(model, clip, time_s);
        return transformed(posed(*model.meshes[static_cast<std::size_t>(model.nodes[i].mesh)],
                                 pose_of(model, node, stance)),
                           mesh_to_model(model, node, stance));
    }
    return {};
}

TEST(GltfRig, ComesBackAsItWasWritten)
{
    const Model model = rigged_model(), back = read(model);
    EXPECT_TRUE(back.notices.empty()) << back.notices.front();
    ASSERT_EQ(back.clips.size(), 2u);
    for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_EQ(back.clips[c].name, model.clips[c].name);
        EXPECT_EQ(back.clips[c].end_s, 1);
        for (const double time : {0.0, 0.4, 1.0}) {
            const Mesh a = posed_at(model, &model.clips[c], time),
                       b = posed_at(back, &back.clips[c], time);
            ASSERT_EQ(a.vertex_count(), b.vertex_count());
            for (std::size_t v = 0; v < a.vertex_count(); ++v)
                EXPECT_LT(glm::distance(a.positions[v], b.positions[v]), 1e-6);
        }
    }
}

TEST(GltfRig, StandsUpAndGrowsWithTheUpAxisAndTheScale)
{
    const Model model = rigged_model();
    const Model back = read_model_bytes(gltf_text(model), "rigged.gltf", "", {.scale = 2});
    const Mesh a = posed_at(model, &model.clips[0], 1), b = posed_at(back, &back.clips[0], 1);
    for (std::size_t v = 0; v < a.vertex_count(); ++v) {
        const glm::vec3 p = a.positions[v];
        EXPECT_LT(glm::distance(b.positions[v], 2.0f * glm::vec3(p.x, -p.z, p.y)), 1e-5);
    }
}

TEST(GltfRig, SaysWhatIsLeftOut)
{
    Model model = rigged_model();
    Mesh mesh = *model.meshes[0];
    for (Mesh::Influences& by : mesh.influences) by.weights = {0, 0, 0, 0};
    model.meshes[0] = make_ref(mesh);
    EXPECT_THAT(read(model).notices, Contains(HasSubstr("have no weight")));

    model = rigged_model();
    model.clips[0].channels[0].times_s = {1, 0};
    EXPECT_THAT(read(model).notices, Contains(HasSubstr("one track of its animations has times")));
    EXPECT_EQ(read(model).clips.size(), 1u);

    model = rigged_model();
    Channel later = model.clips[0].channels[0];
    later.node = 1;
    later.times_s.back() = 3;
    model.clips[0].channels.push_back(later);
    EXPECT_THAT(read(model).notices,
                Contains(HasSubstr("one track of its animations begins later")));

    model = rigged_model();
    model.skins[0].joints = {1, 77};
    const Model boneless = read(model);
    EXPECT_THAT(boneless.notices, Contains(HasSubstr("one skin lacks joints")));
    EXPECT_EQ(boneless.nodes[0].skin, -1);
}

// The text with its joints and weights named twice more, so that vertices have up to six shares.
std::string crowded(std::string text)
{
    const std::size_t begin = text.find("\"JOINTS_0\""), end = text.find('}', begin);
    const std::string once = text.substr(begin, end - begin);
    for (const char* set : {"1", "2"}) {
        std::string more = "," + once;
        for (const char* name : {"JOINTS_", "WEIGHTS_"})
            more.replace(more.find(name) + std::string(name).size(), 1, set);
        text.insert(end, more);
    }
    return text;
}

TEST(GltfRig, KeepsTheFourLargestSharesOfMoreThanFourJoints)
{
    const Model model = rigged_model();
    const Model back = read_model_bytes(crowded(gltf_text(model)), "rigged.gltf", "", {});
    EXPECT_THAT(back.notices, Contains(HasSubstr("are bound to more than four joints")));
    ASSERT_EQ(back.meshes[0]->influences.size(), model.meshes[0]->influences.size());
    for (std::size_t v = 0; v < model.meshes[0]->influences.size(); ++v) {
        const Mesh::Influences &was = model.meshes[0]->influences[v],
                               &is = back.meshes[0]->influences[v];
        float tip = 0, of = 0, kept = 0;
        for (int k = 0; k < 4; ++k) {
            tip += was.joints[std::size_t(k)] == 1 ? was.weights[k] : 0;
            of += is.weights[k];
            kept += is.joints[std::size_t(k)] == 1 ? is.weights[k] : 0;
        }
        EXPECT_NEAR(of, 1, 1e-6);
        // Three shares of the larger one and one of the other are the four largest.
        const float larger = std::max(tip, 1 - tip), other = 1 - larger;
        const float share = larger > other ? 3 * larger / (3 * larger + other) : 0.5f;
        EXPECT_NEAR(std::max(kept, 1 - kept), share, 1e-6) << v;
    }
}

TEST(GltfRig, LeavesOutASkinWithoutWeights)
{
    std::string text = gltf_text(rigged_model());
    text.replace(text.find("WEIGHTS_0"), 9, "_WEIGHT_0");
    const Model back = read_model_bytes(text, "rigged.gltf", "", {});
    EXPECT_THAT(back.notices, Contains(HasSubstr("one skin lacks joints or weights")));
    EXPECT_EQ(back.nodes[0].skin, -1);
}

TEST(GltfRig, TakesAClipThatLastsNoTime)
{
    Model model = rigged_model();
    model.clips.erase(model.clips.begin()); // "swell" is left
    model.clips[0].channels[0].times_s = {0.5f};
    model.clips[0].channels[0].values = {0.75f};
    const Model back = read(model);
    ASSERT_EQ(back.clips.size(), 1u);
    EXPECT_EQ(back.clips[0].begin_s, back.clips[0].end_s);
    for (const double time : {0.0, 0.5, 9.0})
        EXPECT_EQ(posed_at(back, &back.clips[0], time).positions,
                  posed_at(back, &back.clips[0], 0.5).positions);
}

TEST(GltfRig, MakesSharesSumToOneAndSaysSo)
{
    const Model model = rigged_model();
    const auto with_weights = [&](const glm::vec4& weights) {
        Model changed = model;
        Mesh mesh = *model.meshes[0];
        for (Mesh::Influences& by : mesh.influences) {
            by.joints = {0, 1, 0, 0};
            by.weights = weights;
        }
        changed.meshes[0] = make_ref(mesh);
        return read(changed);
    };
    const Model ten = with_weights({4, 6, 0, 0});
    EXPECT_THAT(ten.notices, Contains(HasSubstr("weights that did not sum to 1")));
    EXPECT_FLOAT_EQ(ten.meshes[0]->influences[0].weights[0], 0.6f);
    const Model negative = with_weights({1, -3, 0, 0});
    EXPECT_THAT(negative.notices, ElementsAre(HasSubstr("a negative weight")));
    EXPECT_EQ(negative.meshes[0]->influences[0].weights, glm::vec4(1, 0, 0, 0));
    EXPECT_THAT(with_weights({0.502f, 0.502f, 0, 0}).notices, IsEmpty()); // bytes that were rounded
}

TEST(GltfRig, TakesRotationsThatAreAllZerosAsNone)
{
    Model model = rigged_model();
    Channel& turns = model.clips[0].channels[0];
    ASSERT_EQ(turns.of, Channel::Of::rotation);
    std::fill_n(turns.values.begin(), 4, 0.0f);
    const Model back = read(model);
    EXPECT_THAT(back.notices, ElementsAre(HasSubstr("one key of its rotations is all zeros")));
    EXPECT_EQ(value_at(back.clips[0].channels[0], 0), (std::vector<double>{0, 0, 0, 1}));

    std::string text = gltf_text(rigged_model());
    text.insert(text.find('{', text.find("\"nodes\":[{")) + 1, R"("rotation":[0,0,0,0],)");
    const Model still = read_model_bytes(text, "still.gltf", "", {.up = UpAxis::z});
    EXPECT_THAT(still.notices, Contains(HasSubstr("the rotation of one node is all zeros")));
    EXPECT_EQ(still.nodes[0].rest.rotation, glm::dquat(1, 0, 0, 0));
}

TEST(GltfRig, GivesTheSecondClipOfANameANumberAndSaysSo)
{
    Model model = rigged_model();
    model.clips[1].name = model.clips[0].name;
    const Model back = read(model);
    EXPECT_THAT(back.notices, ElementsAre(HasSubstr("one of its animations has the name of")));
    EXPECT_EQ(back.clips[1].name, model.clips[0].name + " 2");
}

TEST(GltfRig, SaysWhatOfAnAnimationItDoesNotKnow)
{
    const nlohmann::json file = nlohmann::json::parse(gltf_text(rigged_model()));
    const auto changed = [&](const auto& change) {
        nlohmann::json other = file;
        change(other);
        return read_model_bytes(other.dump(), "rigged.gltf", "", {});
    };
    const Model wild = changed([](nlohmann::json& other) {
        other["animations"][0]["samplers"][0]["interpolation"] = "WIBBLE";
    });
    EXPECT_THAT(wild.notices, ElementsAre(HasSubstr("an unknown interpolation")));
    const Model half = changed([](nlohmann::json& other) {
        nlohmann::json& attributes = other["meshes"][0]["primitives"][0]["attributes"];
        attributes["JOINTS_1"] = attributes["JOINTS_0"];
    });
    EXPECT_THAT(half.notices, ElementsAre(HasSubstr("has further joints without weights")));
    const Model whole = changed([](nlohmann::json& other) {
        const auto times = other["animations"][0]["samplers"][0]["input"].get<std::size_t>();
        other["accessors"][times]["componentType"] = 5125;
    });
    EXPECT_THAT(whole.notices, Contains(HasSubstr("has whole numbers for times")));
    for (const Clip& clip : whole.clips) EXPECT_LE(clip.end_s, 1) << clip.name;
    const Model none = changed([](nlohmann::json& other) {
        other["animations"][0]["channels"] = nlohmann::json::array();
    });
    EXPECT_THAT(none.notices, ElementsAre(HasSubstr("one of its animations has no track to play")));
    const Model aimless = changed([](nlohmann::json& other) {
        for (nlohmann::json& channel : other["animations"][0]["channels"])
            channel["target"].erase("node");
    });
    EXPECT_THAT(aimless.notices, Contains(HasSubstr("one of its animations has no track to play")));
    EXPECT_EQ(aimless.clips.size(), 1u);
    const Model named =
        changed([](nlohmann::json& other) { other["animations"][0]["name"] = "walk\n\a on"; });
    EXPECT_EQ(named.clips[0].name, "walk?? on");
}

TEST(GltfRig, RefusesJointsThatAreNotThere)
{
    Model model = rigged_model();
    Mesh mesh = *model.meshes[0];
    mesh.influences.back().joints[1] = 9;
    model.meshes[0] = make_ref(mesh);
    try {
        read(model);
        FAIL() << "was read";
    } catch (const Rejected& why) {
        EXPECT_THAT(why.what(), HasSubstr("joint 9"));
    }
}

TEST(RealDataGltf, AnimatedModelsHaveTheirClips)
{
    const std::string folder = real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    const Model fox = read_model(folder + "/animated/Fox.glb");
    ASSERT_EQ(fox.clips.size(), 3u);
    EXPECT_EQ(fox.clips[1].name, "Walk");
    EXPECT_EQ(fox.skins.at(0).joints.size(), 24u);
    const Box walking = bounding_box(posed_at(fox, &fox.clips[1], 0.3)),
              standing = bounding_box(*fox.meshes[0]);
    EXPECT_NEAR(glm::length(walking.size()), glm::length(standing.size()),
                0.3 * glm::length(standing.size()));
    EXPECT_GT(walking.size().z, 50) << "it stands on its legs";
    EXPECT_NEAR(walking.lo.z, 0, 5);

    const Model cube =
        read_model(folder + "/animated/AnimatedMorphCube/glTF/AnimatedMorphCube.gltf");
    EXPECT_EQ(cube.meshes.at(0)->morph_targets.size(), 2u);
    EXPECT_NE(posed_at(cube, &cube.clips.at(0), 1.0).positions,
              posed_at(cube, nullptr, 0).positions);
}

} // namespace
} // namespace trivar

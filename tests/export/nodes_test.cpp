// SPDX-License-Identifier: GPL-3.0-or-later
// What is a node of a file: objects, their parts, and the render camera.
#include "core/commands/objects/group.h"
#include "core/commands/objects/view.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "core/export/still_export.h"
#include "core/files/formats.h"
#include "core/mesh/pose.h"
#include "core/mesh/primitives.h"
#include "tests/export/scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using Claim = FilmCertificate::PartClaim;

// With an ant 6 of two meshes, in the group 7.
class NodesOfFiles : public testing::ExportedScenes {
protected:
    NodesOfFiles()
    {
        Model ant = single_mesh_model("body", box_mesh({1, 0.4, 0.4}, {4, 1, 1}));
        ant.meshes.push_back(make_ref(box_mesh({0.2, 0.8, 0.1}, {1, 4, 1})));
        ant.nodes.push_back({.name = "leg", .parent = 0, .mesh = 1});
        testing::write_file(folder_.file("ant.glb"), write_glb(ant));
        ImportModel import;
        import.file.path = "ant.glb";
        import.file.scale = 0.2;
        import.name = "Ant 1";
        still_ = after(after(still_, import), Group{{6}, "Nest"});
    }
};

int node_named(const Model& model, const std::string& name)
{
    const auto at = std::ranges::find(model.nodes, name, &Node::name);
    EXPECT_EQ(std::ranges::count(model.nodes, name, &Node::name), 1) << name;
    return at == model.nodes.end() ? -1 : static_cast<int>(at - model.nodes.begin());
}

std::string parent_of(const Model& model, const std::string& name)
{
    const int at = node_named(model, name);
    const int parent = at < 0 ? -1 : model.nodes[static_cast<std::size_t>(at)].parent;
    return parent < 0 ? "" : model.nodes[static_cast<std::size_t>(parent)].name;
}

void expect_the_tree(const Model& model, const std::string& root)
{
    EXPECT_EQ(parent_of(model, "Nest"), root);
    EXPECT_EQ(parent_of(model, "Ant 1"), "Nest");
    EXPECT_EQ(parent_of(model, "Ant 1 body"), "Ant 1");
    EXPECT_EQ(parent_of(model, "Ant 1 leg"), "Ant 1");
    EXPECT_EQ(parent_of(model, "Ball"), root); // which has one part
}

TEST_F(NodesOfFiles, AreObjectsInTheirGroupsWithTheirPartsBelow)
{
    Evaluator evaluate(assets_);
    const Evaluation evaluated = evaluate(still_);
    const Model model = export_of(evaluated, {.document = still_, .log = {}}).model;
    expect_the_tree(model, "");
    std::size_t parts = 0;
    for (const auto& [id, object] : evaluated.objects) parts += object->parts.size();
    EXPECT_EQ(model.meshes.size(), parts);
}

TEST_F(NodesOfFiles, AreTheSameInAnAnimationInAVolume)
{
    PlacementParameters p;
    p.fill = 0.4;
    Document document = after(still_, Place{6, testing::small_sketch(), p, {1}});
    document = after(document, SetTravel{{6}, {.speed = 1}});
    const AnimatedExport made = exported(document);
    expect_the_tree(made.model, "Scene");
    for (const Claim& claim : of(made, 6)) EXPECT_EQ(claim.way, "targets");
    expect_holds(document, made);
}

TEST_F(NodesOfFiles, HaveTheRenderCameraWithItsKeys)
{
    Camera camera{.eye = {4, -6, 3}, .target = {0, 0, 1}};
    const Document resting = after(still_, KeepView{"picture", camera});
    Evaluator evaluate(assets_);
    const Model still = export_of(evaluate(resting), {.document = resting, .log = {}}).model;
    ASSERT_EQ(still.cameras.size(), 1u);
    const auto there = [](const Model& model) {
        return model.nodes[static_cast<std::size_t>(node_named(model, "Render camera"))];
    };
    EXPECT_EQ(there(still).to_parent, glm::inverse(view_matrix(camera)));
    EXPECT_TRUE(export_of(evaluate(still_), {.document = still_, .log = {}}).model.cameras.empty());

    Animate keys;
    keys.of.push_back({0,
                       {{.parameter = "camera.picture.eye.x",
                         .keys = {{.frame = 1, .value = 4}, {.frame = 7, .value = -4}}}}});
    const Document moving = after(resting, keys);
    const AnimatedExport made = exported(moving);
    const int node = node_named(made.model, "Render camera");
    ASSERT_EQ(made.model.clips.size(), 1u);
    for (const double frame : {1.0, 3.0, 5.0, 7.0}) {
        const Camera now = document_at(moving, frame).kept_views.at("picture");
        const Stance stance = stance_at(made.model, &made.model.clips[0], (frame - 1) / 12);
        const glm::dmat4 at = stance.to_model[static_cast<std::size_t>(node)];
        // The camera's target stays in the middle of its picture.
        const glm::dvec4 seen = glm::inverse(at) * glm::dvec4(now.target, 1);
        EXPECT_LT(glm::length(glm::dvec2(seen)), 0.01) << frame;
        EXPECT_LT(glm::distance(glm::dvec3(at[3]), now.eye), 0.01) << frame;
    }
    EXPECT_TRUE(made.left_out.empty());
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/evaluation/evaluate.h"
#include "editor/files/plain_mesh.h"

#include "core/commands/placement/apply_shape.h"
#include "core/document/document_digest.h"
#include "editor/actions/actions.h"
#include "editor/actions/placement_actions.h"
#include "tests/editor/laid.h"
#include "tests/support/fixtures.h"

#include <filesystem>

namespace trivar {
namespace {

using testing::LaidRig;

// In a scene that has a folder.
struct SavedLaid : LaidRig {
    SavedLaid()
    {
        editor.session.save_as(folder.file("scene.trivar"));
        wait();
        editor.session.selected = 2;
        frames();
    }
    Box bounds(Id id) const { return *editor.session.evaluated().objects.at(id)->bounds; }
    std::size_t triangles(Id id) const
    {
        std::size_t sum = 0;
        for (const Part& part : editor.session.evaluated().objects.at(id)->parts)
            sum += part.mesh()->face_count();
        return sum;
    }
    // Asks in the dialog, with another tolerance.
    void ask(const char* name, double tolerance)
    {
        action(editor, name).run(editor);
        auto& dialog = editor.memory.of<PlainMeshDialog>();
        ASSERT_TRUE(dialog.open);
        EXPECT_EQ(dialog.wish.refining.tolerance, Refining{}.tolerance);
        dialog.wish.refining.tolerance = tolerance;
        frames();
        const PlainMeshWish wish = dialog.wish;
        dialog.open = false;
        make_plain_mesh(editor.session, wish);
        wait();
    }
    testing::TemporaryFolder folder;
};

void expect_alike(const Box& a, const Box& b, double by)
{
    EXPECT_LT(glm::distance(a.lo, b.lo), by);
    EXPECT_LT(glm::distance(a.hi, b.hi), by);
}

TEST(PlainMesh, ApplyPutsTheCertifiedShapeInItsPlaceInOneStep)
{
    SavedLaid rig;
    const Box before = rig.bounds(2);
    const std::size_t steps = rig.steps();
    rig.ask(apply_shape_action, 2e-3);
    EXPECT_EQ(rig.steps(), steps + 1);
    const Object& now = object(rig.editor.session.document(), 2);
    EXPECT_FALSE(now.stroke);
    ASSERT_TRUE(std::holds_alternative<ImportedFile>(now.source));
    EXPECT_EQ(std::get<ImportedFile>(now.source).path, "Box plain_001.glb");
    expect_alike(rig.bounds(2), before, 4e-3);
    const auto& steps_done = rig.editor.session.scene().history().steps();
    EXPECT_EQ(steps_done.back().command.get<ApplyShape>().tolerance, 2e-3);
    EXPECT_NE(rig.editor.session.notices.all().back().body.find("certified"), std::string::npos);
    // Its origin is in its middle, so that it turns and grows about itself.
    EXPECT_LT(glm::distance(now.transform.translation, rig.bounds(2).center()), 1e-3);
    EXPECT_EQ(rig.editor.session.selected, 2);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.is_laid());
    expect_alike(rig.bounds(2), before, 1e-9);
    EXPECT_TRUE(std::filesystem::exists(rig.folder.file("Box plain_001.glb")))
        << "redo finds it again";
    rig.editor.session.redo();
    rig.wait();
    expect_alike(rig.bounds(2), before, 4e-3);
}

TEST(PlainMesh, ACopyIsAnObjectOfItsOwnThatMovesFreely)
{
    SavedLaid rig;
    const std::size_t steps = rig.steps();
    rig.ask(plain_copy_action, 0.05);
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_TRUE(rig.is_laid()) << "the laid one stays";
    ASSERT_EQ(rig.editor.session.selected, 3);
    EXPECT_EQ(object(rig.editor.session.document(), 3).name, "Box plain");
    expect_alike(rig.bounds(3), rig.bounds(2), 0.1);
    const std::size_t coarse = rig.triangles(3);
    rig.editor.session.selected = 2;
    rig.frames();
    rig.ask(plain_copy_action, 5e-4);
    ASSERT_EQ(rig.editor.session.selected, 4);
    EXPECT_GT(rig.triangles(4), coarse) << "a finer tolerance has more triangles";
    expect_alike(rig.bounds(4), rig.bounds(2), 0.01);
    ASSERT_TRUE(rig.editor.session.run(SetTransform{4, {.translation = {0, 0, 2}}}));
    rig.wait();
    EXPECT_NEAR(rig.bounds(4).center().z, 2, 1e-2);
}

TEST(PlainMesh, WhatLiesOnItStaysOnItAndGoesWithIt)
{
    SavedLaid rig;
    AddBox small;
    small.shape.size = {0.3, 0.1, 0.1};
    small.transform.translation = {0, 2, 1};
    ASSERT_TRUE(rig.editor.session.run(small));
    rig.editor.session.selected = 3;
    rig.wait();
    rig.key({'D'});
    const glm::vec2 at = rig.seen_at(rig.middle());
    rig.draw({at - glm::vec2(40, 0), at + glm::vec2(40, 0)});
    rig.wait();
    ASSERT_TRUE(rig.is_laid(3));
    ASSERT_TRUE(rig.step(3).attach);
    ASSERT_EQ(rig.step(3).attach->hosts.at(main_host(*rig.step(3).attach)).object, 2);
    rig.key({'Q'});
    rig.editor.session.selected = 2;
    rig.frames();
    const Box before = rig.bounds(3);
    rig.ask(apply_shape_action, 1e-4);
    ASSERT_TRUE(rig.is_laid(3));
    expect_alike(rig.bounds(3), before, 5e-3);
    Transform moved = object(rig.editor.session.document(), 2).transform;
    moved.translation.x += 0.5;
    ASSERT_TRUE(rig.editor.session.run(SetTransform{2, moved}));
    rig.wait();
    EXPECT_NEAR(rig.bounds(3).center().x, before.center().x + 0.5, 5e-3);
}

TEST(PlainMesh, SaysWhatIsNotCertifiedWhereTheTrianglesDoNotSuffice)
{
    SavedLaid rig;
    make_plain_mesh(rig.editor.session, {2, {.tolerance = 1e-5, .budget = 2000}, true});
    rig.wait();
    const auto& steps_done = rig.editor.session.scene().history().steps();
    EXPECT_EQ(steps_done.back().command.get<ApplyShape>().tolerance, 0);
    EXPECT_EQ(rig.editor.session.notices.all().back().kind, ui::NoticeKind::warning);
}

const std::string& path_of(const testing::Rig& rig, Id id)
{
    return std::get<ImportedFile>(object(rig.editor.session.document(), id).source).path;
}

TEST(PlainMesh, IsMadeInASceneWithoutANameToo)
{
    const testing::TemporaryFolder unnamed, folder;
    std::string effects;
    {
        LaidRig rig({720, 520}, unnamed.path().string());
        ASSERT_TRUE(is_enabled(rig.editor, action(rig.editor, apply_shape_action)));
        make_plain_mesh(rig.editor.session, {2, {.tolerance = 1e-2}, true});
        rig.wait();
        ASSERT_FALSE(object(rig.editor.session.document(), 2).stroke);
        EXPECT_TRUE(path_of(rig, 2).ends_with(" kept shapes/Box plain_001.glb")) << path_of(rig, 2);
        effects = digest(rig.editor.session.evaluated());
        rig.editor.session.save_as(folder.file("scene.trivar"));
        rig.wait();
        EXPECT_EQ(path_of(rig, 2), "Box plain_001.glb");
        EXPECT_EQ(digest(rig.editor.session.evaluated()), effects);
        for (const auto& each : std::filesystem::directory_iterator(unnamed.path()))
            EXPECT_TRUE(each.path().filename().string().starts_with("life-sign"));
    }
    testing::Rig again;
    again.editor.session.replace_scene(SceneFile(folder.file("scene.trivar")));
    again.wait();
    EXPECT_EQ(digest(again.editor.session.evaluated()), effects);
}

TEST(PlainMesh, ComesAlongWhereTheSceneIsSavedWhileItIsMade)
{
    const testing::TemporaryFolder unnamed, folder, other;
    LaidRig rig({720, 520}, unnamed.path().string());
    make_plain_mesh(rig.editor.session, {2, {.tolerance = 1e-2}, false});
    rig.editor.session.save_as(folder.file("scene.trivar"));
    rig.wait();
    ASSERT_TRUE(rig.editor.session.document().objects.contains(3));
    EXPECT_EQ(path_of(rig, 3), "Box plain_001.glb");
    rig.editor.session.selected = 2;
    make_plain_mesh(rig.editor.session, {2, {.tolerance = 2e-2}, false});
    rig.editor.session.save_as(other.file("scene.trivar"));
    rig.wait();
    EXPECT_EQ(path_of(rig, 4), "Box plain_001.glb") << "beside the scene, whose name is free there";
    EXPECT_TRUE(std::filesystem::exists(other.file("Box plain_001.glb")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("Box plain_002.glb")));
}

TEST(PlainMesh, IsOfferedForWhatIsLaidAlone)
{
    SavedLaid rig;
    EXPECT_TRUE(is_enabled(rig.editor, action(rig.editor, apply_shape_action)));
    rig.editor.session.selected = 1;
    EXPECT_FALSE(is_enabled(rig.editor, action(rig.editor, plain_copy_action)));
}

TEST(PlainMesh, IsNotOfferedWhereNothingOfASceneIsOnDisk)
{
    LaidRig rig;
    EXPECT_FALSE(is_enabled(rig.editor, action(rig.editor, apply_shape_action)));
}

} // namespace
} // namespace trivar

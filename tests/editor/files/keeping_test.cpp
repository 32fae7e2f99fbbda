// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of work that is let go, and what the window says of it.
#include "core/commands/objects/arrange.h"
#include "core/files/write_model.h"
#include "core/mesh/primitives.h"
#include "core/scene/log.h"
#include "editor/files/volume_offer.h"
#include "editor/session/recovery.h"
#include "editor/session/scene_facts.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <future>
#include <imgui.h>

namespace trivar {
namespace {

using testing::Rig;

TEST(Keeping, ADiscardedSceneCanBeBroughtBackAtOnce)
{
    const testing::TemporaryFolder folder;
    Session session([] {}, folder.path().string());
    Recovery recovery(session);
    ASSERT_TRUE(session.run(AddBox{}));
    session.replace_scene(SceneFile());
    EXPECT_TRUE(session.document().objects.empty());
    ASSERT_EQ(session.notices.all().size(), 1u);
    ASSERT_EQ(session.notices.all().front().actions.size(), 1u);
    const auto bring_back = session.notices.all().front().actions.front().act;
    bring_back();
    EXPECT_EQ(session.document().objects.size(), 1u);
    EXPECT_TRUE(SceneFile::set_aside_in(folder.path().string()).empty());
}

TEST(Keeping, TheKeyboardReachesEveryButtonOfAQuestion)
{
    for (const int tabs : {0, 1, 2}) {
        Rig rig;
        ASSERT_TRUE(rig.editor.session.run(AddBox{}));
        rig.editor.files.new_scene();
        rig.frames();
        ASSERT_TRUE(rig.editor.files.asking());
        for (int i = 0; i < tabs; ++i) rig.key({ui::key_tab});
        rig.key({ui::key_enter});
        // Name it..., Discard, Cancel: the first goes on to ask for the name.
        EXPECT_EQ(rig.editor.files.asking(), tabs == 0);
        EXPECT_EQ(rig.editor.session.document().objects.empty(), tabs == 1);
    }
}

TEST(Keeping, ACopyOfASceneThatIsOpenElsewhereOffersToBeSaved)
{
    const testing::TemporaryFolder folder;
    SceneFile other;
    other.run(AddBox{});
    other.save_as(folder.file("a.trivar"));
    Rig rig;
    rig.editor.session.notices.say(ui::NoticeKind::good, "Said of the scene before", {});
    rig.editor.files.open_scene(folder.file("a.trivar"));
    rig.wait();
    ASSERT_TRUE(rig.editor.files.asking());
    rig.key({ui::key_left}); // from Look only to Open a copy
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.editor.session.document().objects.size(), 1u);
    const auto& notices = rig.editor.session.notices.all();
    ASSERT_EQ(notices.size(), 1u);
    ASSERT_EQ(notices.front().actions.size(), 1u);
    const ui::Notices::Action save = notices.front().actions.front();
    EXPECT_EQ(save.words, "Save as...");
    save.act();
    EXPECT_TRUE(rig.editor.files.asking());
}

// A scene that is asked for behind a job which goes on till it is let go.
struct OpeningLate {
    testing::TemporaryFolder folder;
    std::string path = folder.file("a.trivar");
    std::promise<void> gate;
    Rig rig;
    OpeningLate()
    {
        SceneFile scene;
        scene.run(AddBox{});
        scene.save_as(path);
        scene = SceneFile();
        rig.editor.session.jobs().start({"Waiting",
                                         [this](const Progress&) -> Jobs::Finish {
                                             gate.get_future().wait();
                                             return [] {};
                                         },
                                         nullptr});
        rig.editor.files.open_scene(path);
    }
    const SceneFile& opened()
    {
        gate.set_value();
        rig.wait();
        return rig.editor.session.scene();
    }
};

TEST(Keeping, KeysMakeNoStepInASceneWhosePlaceAnotherIsAboutToTake)
{
    OpeningLate late;
    late.rig.key({.key = 'A', .shift = true});
    late.rig.type("b");
    EXPECT_EQ(late.rig.steps(), 0u);
    EXPECT_EQ(late.opened().path(), late.path);
    late.rig.key({.key = 'A', .shift = true});
    late.rig.type("b");
    EXPECT_EQ(late.rig.steps(), 2u);
}

TEST(Keeping, AStepThatCameWhileAnotherSceneWasReadIsNotLetGoUnasked)
{
    OpeningLate late;
    ASSERT_TRUE(late.rig.editor.session.run(AddSphere{})); // as a model does that was being read
    EXPECT_EQ(late.opened().path(), "");
    ASSERT_TRUE(late.rig.editor.files.asking());
    late.rig.key({ui::key_tab}); // from Name it... to Discard
    late.rig.key({ui::key_enter});
    EXPECT_EQ(late.rig.editor.session.scene().path(), late.path);
}

TEST(Keeping, ANewSceneIsSeenFromHomeWithTheSelectingTool)
{
    Rig rig;
    rig.frames();
    rig.editor.session.view.camera.eye = {9, 9, 9};
    rig.editor.choose_tool(1);
    rig.key({.key = 'N', .ctrl = true});
    EXPECT_EQ(rig.editor.session.view.camera.eye, Camera{}.eye);
    EXPECT_EQ(rig.editor.tool, 0u);
}

TEST(Keeping, WhatUndoBringsBackIsSelected)
{
    Rig rig;
    rig.two_objects();
    Session& session = rig.editor.session;
    session.selected = 2;
    ASSERT_TRUE(session.run(Rename{1, "Ground"}));
    session.undo();
    EXPECT_EQ(session.selected, 2); // as it was
    ASSERT_TRUE(session.run(Delete{{2}}));
    EXPECT_EQ(session.selected, 0);
    session.undo();
    EXPECT_EQ(session.selected, 2);
    session.undo();
    session.undo();
    session.redo();
    EXPECT_EQ(session.selected, 1);
}

TEST(Menus, AreGoneThroughWithTheArrowsAndLetters)
{
    Rig rig;
    rig.frames();
    rig.key({.key = 'A', .shift = true});
    rig.key({ui::key_down});
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId));
    rig.key({.key = 'A', .shift = true});
    rig.type("b");
    EXPECT_EQ(name_of(rig.editor.session.document(), 2), "Box");
    rig.key({.key = 'A', .shift = true});
    rig.key({ui::key_escape});
    EXPECT_FALSE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId));
    EXPECT_EQ(rig.steps(), 2u);
}

TEST(Keeping, TheNoticeOfALeftSceneStaysAndTheMenuFindsTheSceneAsLong)
{
    const testing::TemporaryFolder folder;
    Session session([] {}, folder.path().string());
    Recovery recovery(session);
    Files files(session, recovery);
    testing::write_file(folder.file("untitled-1.trivar"), log_header() + command_line(AddBox{}));
    ASSERT_TRUE(SceneFile::left_in(folder.path().string()));
    recovery.tell_of_left_scene();
    ASSERT_EQ(session.notices.all().size(), 1u);
    EXPECT_TRUE(session.notices.all().front().stays);
    for (int i = 0; i < 4; ++i)
        session.notices.say(ui::NoticeKind::good, "Notice " + std::to_string(i));
    EXPECT_TRUE(session.notices.all().front().stays) << "others make room for themselves";
    session.notices.clear(); // as its cross does
    files.ask_discarded();
    EXPECT_EQ(session.document().objects.size(), 1u);
}

TEST(Keeping, AFileThatCannotBeSavedLeavesTheDialogWithItsPath)
{
    const testing::TemporaryFolder folder;
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddBox{}));
    rig.editor.preferences.scenes_folder = folder.path().string();
    rig.frames();
    rig.editor.files.ask_save_as();
    rig.frames();
    const std::string longer_than_a_file_may_be(300, 'x');
    rig.type(longer_than_a_file_may_be);
    rig.key({ui::key_enter});
    EXPECT_TRUE(rig.editor.files.asking()) << "to be named otherwise";
    EXPECT_TRUE(rig.editor.session.notices.all().empty()) << "the dialog says why";
    EXPECT_EQ(rig.editor.session.scene().path(), "");
    rig.key({.key = 'A', .ctrl = true});
    rig.type("short");
    rig.key({ui::key_enter});
    EXPECT_FALSE(rig.editor.files.asking());
    EXPECT_NE(rig.editor.session.scene().path(), "");
}

TEST(Keeping, TheSaveDialogBeginsWhereScenesAreAndNotWhereTheLastModelCameFrom)
{
    const testing::TemporaryFolder scenes, models;
    testing::write_file(models.file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Rig rig;
    rig.editor.preferences.scenes_folder = scenes.path().string();
    rig.frames();
    rig.editor.files.ask_import();
    rig.frames();
    rig.key({.key = 'A', .ctrl = true});
    rig.type(models.file("a.obj"));
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.editor.session.document().objects.size(), 1u);
    rig.editor.files.ask_save_as();
    rig.frames();
    rig.key({.key = 'A', .ctrl = true});
    rig.type("mine");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.editor.session.scene().path(), scenes.file("mine.trivar"));
}

TEST(Keeping, WhatIsDroppedWaitsForTheAnswerToADialog)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddBox{}));
    rig.editor.files.ask_export();
    rig.frames();
    rig.screen.input().push(ui::drop_files({folder.file("a.obj")}));
    rig.wait();
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.editor.session.document().objects.size(), 2u);
}

TEST(Keeping, ASceneOpensAsItWasLookedAtLast)
{
    const testing::TemporaryFolder folder;
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddBox{}));
    rig.editor.session.save_as(folder.file("a.trivar"));
    rig.wait();
    rig.editor.session.view.camera.eye = {-3, 7, 2};
    rig.editor.session.view.camera.target = {0.5, 0, 0.25};
    rig.frames();
    rig.editor.files.new_scene();
    rig.frames();
    EXPECT_NE(rig.editor.session.view.camera.eye, glm::dvec3(-3, 7, 2));
    rig.editor.files.open_scene(folder.file("a.trivar"));
    rig.wait();
    EXPECT_EQ(rig.editor.session.view.camera.eye, glm::dvec3(-3, 7, 2));
    EXPECT_EQ(rig.editor.session.view.camera.target, glm::dvec3(0.5, 0, 0.25));
}

TEST(Keeping, AModelAHundredTimesTheSceneIsSaidAndScaledWhereThatIsWanted)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("fox.obj"), "v 0 0 0\nv 200 0 0\nv 0 200 0\nf 1 2 3\n");
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddBox{}));
    rig.wait();
    rig.editor.files.import(folder.file("fox.obj"));
    rig.wait();
    rig.frames();
    const auto& notices = rig.editor.session.notices.all();
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_EQ(notices[0].title, "Fox is about 100 times larger than the rest of the scene");
    ASSERT_EQ(notices[0].actions.size(), 1u);
    const auto scale = notices[0].actions[0].act;
    scale();
    EXPECT_EQ(object(rig.editor.session.document(), 2).transform.scale, glm::dvec3(0.01));
}

TEST(Keeping, AScanInFacetsIsSaidAndShadedByAngleWhereThatIsWanted)
{
    const testing::TemporaryFolder folder;
    write_model(single_mesh_model("scan", sphere_mesh(1, 80, 40)), folder.file("scan.stl"));
    write_model(single_mesh_model("part", box_mesh({1, 1, 1}, {20, 20, 20})),
                folder.file("part.stl"));
    Rig rig;
    for (const char* name : {"part.stl", "scan.stl"}) {
        rig.editor.files.import(folder.file(name));
        rig.wait();
        rig.frames();
    }
    const auto& notices = rig.editor.session.notices.all();
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_EQ(notices[0].title, "Scan is shaded flat");
    ASSERT_EQ(notices[0].actions.size(), 1u);
    const auto shade = notices[0].actions[0].act;
    shade();
    EXPECT_EQ(object(rig.editor.session.document(), 2).shading->way, ShadingWay::by_angle);
}

} // namespace
} // namespace trivar

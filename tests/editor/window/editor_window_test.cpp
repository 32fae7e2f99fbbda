// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/command.h"
#include "core/scene/log.h"
#include "editor/actions/actions.h"
#include "editor/session/scene_facts.h"
#include "editor/session/scene_names.h"
#include "editor/tools/place/place.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"
#include "ui/camera_control.h"

#include <fstream>
#include <gmock/gmock.h>
#include <imgui.h>

namespace trivar {
namespace {

using testing::Rig, ui::Button;

TEST(EditorWindow, AnEmptyEditorSettlesAndThenDrawsNothing)
{
    Rig rig;
    rig.wait();
    EXPECT_LT(rig.screen.settle(rig.body(), 200), 60);
    const long pictures = rig.editor.viewport.pictures();
    rig.frames(20);
    EXPECT_EQ(rig.editor.viewport.pictures(), pictures)
        << "the scene is drawn only when it changes";
}

TEST(EditorWindow, AStrokeIsOneStepThatCanBeUndoneAndRedone)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    EXPECT_EQ(rig.editor.active_tool().name(), "Place");
    rig.draw(rig.stroke());
    rig.wait();
    ASSERT_EQ(rig.steps(), 3u) << (rig.editor.session.notices.all().empty()
                                       ? ""
                                       : rig.editor.session.notices.all().back().body);
    EXPECT_TRUE(rig.editor.session.evaluated().objects.at(2)->placement);

    rig.key({.key = 'Z', .ctrl = true});
    rig.wait();
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(2)->placement);

    rig.key({.key = 'Z', .ctrl = true, .shift = true});
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_TRUE(rig.editor.session.evaluated().objects.at(2)->placement);
}

TEST(EditorWindow, AStrokeIsSeenBeforeTheButtonIsLetGoAndEscapeTakesItBack)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke(), false);
    rig.wait();
    EXPECT_TRUE(rig.editor.session.proposing());
    EXPECT_TRUE(rig.editor.session.evaluated().objects.at(2)->placement);
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(Button::left, false));
    rig.wait();
    EXPECT_FALSE(rig.editor.session.proposing());
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_EQ(rig.editor.session.scene().history().steps().size(), 2u);
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(2)->placement);
}

TEST(EditorWindow, AWidthTypedWhileTheButtonIsHeldIsThatOfTheStroke)
{
    Rig rig({1024, 700});
    rig.two_objects();
    rig.key({'D'});
    rig.draw(rig.stroke(), false);
    rig.type("25 cn");
    rig.key({ui::key_backspace});
    rig.type("m");
    rig.frames();
    const auto hints = rig.editor.active_tool().hints(rig.editor.session);
    EXPECT_EQ(hints.front().verb, "Width 25 cm| = 0.25 m");
    rig.wait();
    rig.frames(4);
    ASSERT_TRUE(rig.editor.session.proposing());
    EXPECT_EQ(object(rig.editor.session.document(), 2).stroke->parameters.width, 0.25);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    ASSERT_EQ(rig.steps(), 3u);
    EXPECT_EQ(object(rig.editor.session.committed(), 2).stroke->parameters.width, 0.25);
    EXPECT_LE(rig.editor.session.notices.all().size(), 1u) << "one stroke, one notice";
}

TEST(EditorWindow, AClickOrAStrokeBesideTheSceneSaysWhatToDoAndChangesNothing)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    rig.click(rig.layout().view.center());
    rig.wait();
    EXPECT_EQ(rig.steps(), 2u);
    ASSERT_FALSE(rig.editor.session.notices.all().empty());
    EXPECT_EQ(rig.editor.session.notices.all().back().body,
              "Draw a line across the scene before you let go.");
    rig.editor.session.notices.clear();
    rig.editor.session.view.camera.target = {0, 0, 3}; // above, the sky
    rig.frames(3);
    const glm::vec2 corner = rig.layout().view.lo + glm::vec2(200, 8);
    rig.draw({corner, corner + glm::vec2(60, 0), corner + glm::vec2(120, 4)});
    rig.wait();
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
}

TEST(EditorWindow, AChangeOfWhatLiesIsCalledAChangeAndNoneIsNoStep)
{
    Rig rig;
    rig.two_objects();
    AddPlane narrow; // beside which the stroke meets nothing
    narrow.shape.size = {1, 1};
    Session& session = rig.editor.session;
    ASSERT_TRUE(session.run(narrow));
    ASSERT_TRUE(session.run(testing::placed(2, 3)));
    rig.wait();
    session.notices.clear();
    session.selected = 0; // else the inspector says it
    PlacementParameters wider = object(session.committed(), 2).stroke->parameters;
    wider.width = 0.3;
    const std::size_t steps = rig.steps();
    ASSERT_TRUE(session.propose(EditPlacement{2, wider, {}, {}}));
    session.commit_if_placed(2);
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
    ASSERT_FALSE(session.notices.all().empty());
    EXPECT_EQ(session.notices.all().back().title, "Box was changed");
    ASSERT_TRUE(session.propose(EditPlacement{2, wider, {}, {}}));
    session.commit_if_placed(2);
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
}

// The first number field down the inspector, found by the cursor that it shows.
std::optional<glm::vec2> find_field(Rig& rig)
{
    const ui::Rect panel = rig.layout().inspector;
    const int steps = static_cast<int>((panel.hi.y - panel.lo.y) / 12);
    for (int step = 0; step < steps; ++step) {
        const glm::vec2 at{panel.lo.x + 140, panel.lo.y + 4 + 12.0f * static_cast<float>(step)};
        rig.screen.input().push(ui::move_to(at));
        rig.frames(2);
        if (ImGui::GetMouseCursor() == ImGuiMouseCursor_ResizeEW) return at;
    }
    return std::nullopt;
}

TEST(EditorWindow, WhereNothingIsToLieOnThePlaceToolSaysSoBeforeAStroke)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    const auto said = [&] { return rig.editor.active_tool().hints(rig.editor.session).front(); };
    rig.move(rig.seen_at({0, 0, 0}));
    EXPECT_EQ(said().verb, "Drag to lay Box");
    rig.editor.session.view.camera.target = {0, 0, 3};
    rig.frames(3);
    rig.move(rig.layout().view.lo + glm::vec2(200, 8)); // the sky
    EXPECT_EQ(said().verb, "Nothing under the pointer to place on");
    EXPECT_TRUE(said().inputs.empty());
    rig.editor.session.view.camera.target = {0, 0, 0};
    rig.frames(3);
    rig.move(rig.seen_at({0, 0, 0}));
    EXPECT_FALSE(said().inputs.empty());
}

TEST(EditorWindow, DraggingAFieldOfTheInspectorIsOneStep)
{
    Rig rig;
    rig.two_objects();
    const auto field = find_field(rig);
    ASSERT_TRUE(field);
    rig.draw({*field, *field + glm::vec2(60, 0)});
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_EQ(verb(rig.editor.session.scene().history().steps()[2].command), "transform");
    EXPECT_GT(object(rig.editor.session.committed(), 2).transform.translation.x, 0);
}

TEST(EditorWindow, EscapeDuringADragInTheInspectorLeavesNoTrace)
{
    Rig rig;
    rig.two_objects();
    const auto field = find_field(rig);
    ASSERT_TRUE(field);
    rig.draw({*field, *field + glm::vec2(60, 0)}, false);
    EXPECT_TRUE(rig.editor.session.proposing());
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_FALSE(rig.editor.session.proposing());
    EXPECT_EQ(object(rig.editor.session.committed(), 2).transform.translation.x, 0);
}

TEST(EditorWindow, ADroppedModelIsImportedAndABrokenOneIsRefusedInASentence)
{
    const testing::TemporaryFolder folder;
    std::ofstream(folder.file("good.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(folder.file("bad.obj")) << "v 0 0 0\nf 1 2 99\n";
    Rig rig;
    rig.screen.input().push(ui::drop_files({folder.file("good.obj")}));
    rig.wait();
    ASSERT_EQ(rig.editor.session.document().objects.size(), 1u);
    EXPECT_EQ(rig.editor.session.selected, 1);
    rig.screen.input().push(ui::drop_files({folder.file("bad.obj")}));
    rig.wait();
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
    ASSERT_FALSE(rig.editor.session.notices.all().empty());
    const auto& refusal = rig.editor.session.notices.all().back();
    EXPECT_EQ(refusal.title, "bad.obj was not imported");
    EXPECT_THAT(refusal.body, ::testing::EndsWith("."));
    EXPECT_THAT(refusal.body, ::testing::Not(::testing::HasSubstr("bad.obj")))
        << "the title names it already";
}

TEST(EditorWindow, ASavedSceneOpensAgainWithItsUndo)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("scene.trivar");
    {
        Rig rig;
        rig.two_objects();
        rig.editor.session.save_as(path);
        rig.editor.session.run(Rename{2, "Brick"});
        rig.wait();
    }
    Rig rig;
    rig.screen.input().push(ui::drop_files({path}));
    rig.wait();
    EXPECT_EQ(name_of(rig.editor.session.document(), 2), "Brick");
    rig.key({.key = 'Z', .ctrl = true});
    EXPECT_EQ(name_of(rig.editor.session.document(), 2), "Box");
}

TEST(EditorWindow, ASampleOpensAsACopyThatIsAskedForOnlyWhenItWasChanged)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("sample.trivar");
    const std::string text = log_header() + command_line(AddBox{});
    std::ofstream(path) << text;
    for (const bool changed : {false, true}) {
        Rig rig;
        rig.editor.files.samples = {path};
        rig.screen.input().push(ui::drop_files({path}));
        rig.wait();
        EXPECT_EQ(title_of(rig.editor.session.scene()), "sample (copy)");
        if (changed) {
            ASSERT_TRUE(rig.editor.session.run(Rename{1, "Mine"}));
        }
        rig.editor.files.ask_close();
        EXPECT_EQ(rig.editor.files.close_agreed(), !changed);
    }
    EXPECT_EQ(read_text_file(path), text);
}

TEST(EditorWindow, ASceneThatIsOpenElsewhereCanBeLookedAtAndRefusesChanges)
{
    const testing::TemporaryFolder folder;
    SceneFile other;
    other.save_as(folder.file("a.trivar"));
    other.run(AddBox{});
    Rig rig;
    rig.editor.files.open_scene(folder.file("a.trivar"));
    rig.wait();
    ASSERT_TRUE(rig.editor.files.asking());
    rig.key({ui::key_enter});
    Session& session = rig.editor.session;
    ASSERT_TRUE(session.scene().look_only());
    EXPECT_FALSE(session.run(AddTorus{}));
    ASSERT_EQ(session.notices.all().size(), 1u);
    EXPECT_THAT(session.notices.all().front().title,
                ::testing::StartsWith("a.trivar is open read-only"));
    session.selected = 1;
    other.run(AddSphere{});
    session.follow_file(1e6);
    rig.wait();
    EXPECT_EQ(session.evaluated().objects.size(), 2u);
    EXPECT_EQ(session.selected, 1);
    rig.editor.files.open_scene(folder.file("a.trivar"));
    rig.wait();
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.files.asking());
    EXPECT_TRUE(session.scene().look_only());
}

TEST(EditorWindow, ASceneWhoseModelIsGoneSaysSoWhenItOpens)
{
    const testing::TemporaryFolder folder;
    std::ofstream(folder.file("a.trivar")) << log_header() << command_line([] {
        ImportModel import;
        import.file.path = "gone.obj";
        import.name = "Rock";
        return import;
    }());
    Rig rig;
    rig.screen.input().push(ui::drop_files({folder.file("a.trivar")}));
    rig.wait();
    ASSERT_EQ(rig.editor.session.notices.all().size(), 1u);
    EXPECT_THAT(rig.editor.session.notices.all().front().body, ::testing::HasSubstr("gone.obj"));
}

TEST(EditorWindow, AKeptViewShowsAllOfItsPicture)
{
    Rig rig;
    rig.two_objects();
    Camera wide;
    wide.size_px = {2000, 500};
    rig.editor.session.view.go_to = wide;
    rig.frames();
    const Camera& now = rig.editor.session.view.camera;
    EXPECT_EQ(now.size_px, glm::dvec2(rig.layout().view.size()));
    EXPECT_GT(now.fov_y, wide.fov_y);
    EXPECT_EQ(now.eye, wide.eye);
}

TEST(EditorWindow, WhatCarriesALaidModelIsNotLaidByItself)
{
    Rig rig;
    rig.two_objects(); // a plane, and a box over it
    AddBox table;
    table.transform.translation = {0, 0, -0.4}; // its top is over the plane
    ASSERT_TRUE(rig.editor.session.run(table));
    rig.wait();
    rig.editor.session.selected = 0;
    EXPECT_EQ(model_to_place(rig.editor.session, 0), 3) << "the newest that is not placed";
    const Camera& camera = rig.editor.session.view.camera;
    const auto at = [&](double x) { return project(camera, glm::dvec3(x, 0, 0.1)).p_px; };
    Sketch over{camera, {}};
    for (int i = 0; i <= 20; ++i) over.samples.push_back({at(-0.4 + 0.04 * i), 0.02 * i});
    ASSERT_TRUE(rig.editor.session.run(Place{2, over, {}, {}}));
    rig.wait();
    rig.editor.session.selected = 0;
    const EvaluatedObject& box = *rig.editor.session.evaluated().objects.at(2);
    ASSERT_TRUE(box.placement) << box.rejected;
    EXPECT_GT(box.placement->report.contact_share, 0.5);
    EXPECT_EQ(model_to_place(rig.editor.session, 0), 2) << "the table is furniture now";
}

TEST(EditorWindow, RedoSelectsWhatItBringsBackAndTheOldestModelIsNotLaidByItself)
{
    Rig rig;
    rig.two_objects();
    rig.editor.session.undo();
    EXPECT_EQ(rig.editor.session.selected, 0);
    rig.editor.session.redo();
    EXPECT_EQ(rig.editor.session.selected, 2);
    for (const Id selected : {0, 1, 2}) {
        rig.editor.session.selected = selected;
        EXPECT_EQ(model_to_place(rig.editor.session, 0), 2);
    }
    EXPECT_EQ(model_to_place(rig.editor.session, 1), 1) << "the options bar can name any";
}

TEST(EditorWindow, ARestingPictureIsFinishedInPiecesAndThenNothingIsDrawn)
{
    Rig rig;
    rig.two_objects();
    EXPECT_LT(rig.screen.settle(rig.body(), 400), 400);
    EXPECT_FALSE(rig.editor.viewport.full_timings().stages.empty());
}

TEST(EditorWindow, AFieldsMenuCopiesTheCommandThatSetsItsValue)
{
    Rig rig;
    rig.two_objects();
    const auto field = find_field(rig);
    ASSERT_TRUE(field);
    rig.screen.input().push(ui::press(Button::right));
    rig.screen.input().push(ui::press(Button::right, false));
    rig.frames(6);
    const float row = ImGui::GetTextLineHeightWithSpacing();
    rig.click(*field + glm::vec2(20, row * 2.8f));
    const std::string line = ImGui::GetClipboardText();
    EXPECT_EQ(line.substr(0, line.find('\n')),
              to_json_line(SetTransform{2, object(rig.editor.session.committed(), 2).transform}));
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_FALSE(rig.editor.session.proposing());
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/clipboard.h"

#include "core/scene/log.h"
#include "editor/actions/actions.h"
#include "editor/actions/log_lines.h"
#include "editor/session/scene_facts.h"
#include "tests/editor/boxes.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>
#include <imgui.h>

namespace trivar {
namespace {

using testing::Boxes, testing::Rig;
using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::SizeIs, ::testing::StartsWith;

const ui::Chord copy_key{.key = 'C', .ctrl = true}, cut_key{.key = 'X', .ctrl = true},
    paste_key{.key = 'V', .ctrl = true};

const ui::Notices::Notice& said_last(const Rig& rig)
{
    return rig.editor.session.notices.all().back();
}

TEST(Clipboard, PastesOneStepBesideWhatWasCopiedSelectsItAndSaysSo)
{
    Boxes rig;
    const std::size_t before = rig.steps();
    rig.key(copy_key);
    EXPECT_EQ(said_last(rig).title, "Box was copied");
    rig.key(paste_key);
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_EQ(said_last(rig).title, "Box 2 was pasted");
    EXPECT_THAT(rig.editor.session.selected.ids(), ElementsAre(3));
    EXPECT_GT(rig.of(3).translation.x, rig.of(1).translation.x + 1);
    rig.key(paste_key); // and again, beside that one
    EXPECT_GT(rig.of(4).translation.x, rig.of(3).translation.x + 1);
    rig.key({.key = 'Z', .ctrl = true});
    rig.key({.key = 'Z', .ctrl = true});
    EXPECT_EQ(rig.steps(), before);
    EXPECT_THAT(rig.editor.session.notices.all(), SizeIs(1)); // a topic
}

TEST(Clipboard, KnowsAModelByItsFileHoweverThatIsNamed)
{
    const testing::TemporaryFolder disk;
    std::ofstream(disk.file("a.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Rig rig;
    rig.editor.files.import(disk.file("a.obj"));
    rig.wait();
    rig.editor.session.save_as(disk.file("b.trivar"));
    rig.editor.session.selected = 1;
    rig.key(copy_key);
    rig.key(paste_key);
    rig.wait();
    const Document& document = rig.editor.session.document();
    EXPECT_EQ(object(document, 2).source, object(document, 1).source);
    EXPECT_NEAR(object(document, 2).transform.translation.x, 1.1, 1e-9);
}

TEST(Clipboard, BringsWhatWasCutBackWhereItStood)
{
    Boxes rig;
    ASSERT_TRUE(rig.editor.session.run(Rename{1, "Brick"}));
    const Transform stood = rig.of(1);
    rig.key(cut_key);
    EXPECT_EQ(said_last(rig).title, "Brick was cut");
    EXPECT_THAT(rig.editor.session.document().objects, SizeIs(1));
    rig.key(paste_key);
    EXPECT_EQ(rig.of(3), stood);
    EXPECT_EQ(name_of(rig.editor.session.document(), 3), "Brick");
    ASSERT_TRUE(rig.editor.session.run(Lock{{3}}));
    rig.key(cut_key);
    EXPECT_THAT(rig.editor.session.document().objects, SizeIs(2));
    EXPECT_EQ(said_last(rig).title, "Nothing was cut");
}

TEST(Clipboard, HoldsALineThatAnotherSceneAndAnyFileTake)
{
    std::string text;
    {
        Rig from;
        from.editor.session.replace_scene(testing::typical_scene());
        from.editor.session.selected.set({2});
        from.wait();
        from.key(copy_key);
        text = ImGui::GetClipboardText();
    }
    EXPECT_THAT(text, StartsWith("{\"do\":\"paste\""));
    Rig to;
    to.frames();
    ImGui::SetClipboardText(text.c_str());
    to.key(paste_key);
    to.wait();
    const Object& alone = object(to.editor.session.document(), 1);
    EXPECT_FALSE(alone.stroke);
    EXPECT_THAT(said_last(to).body, HasSubstr("has its original shape"));
    EXPECT_NO_THROW(replay(read_log(log_header() + text, "a file")));
}

TEST(Clipboard, SaysHowACopyOfWhatLiesOnAStrokeLies)
{
    Rig rig;
    rig.editor.session.replace_scene(testing::typical_scene());
    rig.editor.session.selected.set({2});
    rig.wait();
    rig.key(copy_key);
    rig.key(paste_key);
    rig.wait();
    const Id made = rig.editor.session.selected;
    EXPECT_EQ(object(rig.editor.session.document(), made).stroke,
              object(rig.editor.session.document(), 2).stroke);
    EXPECT_THAT(said_last(rig).body, HasSubstr("same stroke"));
}

TEST(Clipboard, RefusesWhatAreNoObjectsWithOneSentence)
{
    Boxes rig;
    const std::size_t before = rig.steps();
    for (const char* text :
         {"", "hello", "add_box", "{\"a\":1}", "[1,2]", "{\"do\":\"add_box\"}\nx",
          "{\"trivar\":1,\"units\":\"m\",\"up\":\"z\"}", "\xFF\xFE\n\xFF"}) {
        ImGui::SetClipboardText(text);
        rig.key(paste_key);
        EXPECT_EQ(said_last(rig).title, "Nothing was pasted") << text;
        EXPECT_EQ(rig.steps(), before) << text;
    }
    EXPECT_THAT(rig.editor.session.notices.all(), SizeIs(1));
    ImGui::SetClipboardText("{\"do\":\"paste\",\"copies\":[{\"object\":1}]}");
    rig.key(paste_key);
    EXPECT_THAT(said_last(rig).body, HasSubstr("copies[0].name"));
}

TEST(Clipboard, RunsOtherLinesOfASceneFile)
{
    Boxes rig;
    const std::size_t before = rig.steps();
    ImGui::SetClipboardText("{\"do\":\"add_box\"}\n{\"do\":\"add_torus\"}\n");
    rig.key(paste_key);
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_EQ(said_last(rig).title, "2 lines were run");
}

TEST(Clipboard, LeavesSelectedLinesOfTheLogToTheLog)
{
    Boxes rig;
    rig.editor.tab = Editor::Tab::log;
    rig.frames();
    rig.editor.memory.of<LogLines>() = {.from = 1, .to = 1};
    rig.key(copy_key);
    EXPECT_THAT(ImGui::GetClipboardText(), StartsWith("{\"do\":\"add_box\""));
}

TEST(NewObjects, AreOfAMiddleGreyWhereverTheyAreAdded)
{
    Rig rig;
    rig.frames();
    action(rig.editor, "Sphere").run(rig.editor);
    const std::optional<Surfacing> material = object(rig.editor.session.document(), 1).surfacing;
    ASSERT_TRUE(material);
    EXPECT_EQ(material->base_color, glm::vec4(0.5f, 0.5f, 0.5f, 1));
    EXPECT_EQ(after(Document{}, command_from_json_line("{\"do\":\"add_sphere\"}")).objects.size(),
              1u);
    EXPECT_FALSE(object(after(Document{}, AddSphere{}), 1).surfacing); // old scenes stay white
}

TEST(Clipboard, LinesOfTheLogAreCopiedByTheMenuAsByTheKey)
{
    Boxes rig;
    rig.editor.tab = Editor::Tab::log;
    rig.editor.session.selected = 0;
    rig.frames();
    rig.editor.memory.of<LogLines>() = {.from = 1, .to = 2};
    ASSERT_TRUE(is_enabled(rig.editor, action(rig.editor, "Copy")));
    rig.key({.key = 'E', .alt = true}); // as a menu does, which is opened by a click as well
    rig.key({ui::key_escape});
    action(rig.editor, "Copy").run(rig.editor);
    EXPECT_THAT(ImGui::GetClipboardText(), StartsWith("{\"do\":\"add_box\""));
    EXPECT_EQ(said_last(rig).title, "2 lines were copied");
    rig.click(rig.away()); // into the picture
    EXPECT_FALSE(is_enabled(rig.editor, action(rig.editor, "Copy")));
}

} // namespace
} // namespace trivar

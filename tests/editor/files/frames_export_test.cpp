// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/objects/animate.h"
#include "editor/actions/file_actions.h"
#include "editor/command_line/command_line.h"
#include "editor/files/export_wish.h"
#include "tests/editor/boxes.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Two boxes, one of which rises from frame 1 to 6, saved, with the dialog over them.
struct Exported : testing::Boxes {
    testing::TemporaryFolder disk;
    ExportPlan& plan = editor.memory.of<ExportDialog>().plan;
    Exported()
    {
        Track track;
        track.parameter = "transform.translation.z";
        track.keys = {Key(), Key()};
        track.keys[0].frame = 1;
        track.keys[1].frame = 6;
        track.keys[1].value = 1.5;
        EXPECT_TRUE(editor.session.run(Animate{{{1, {track}}}}));
        editor.session.save_as(disk.file("a.trivar"));
        wait();
        ask_export_frames(editor);
        frames(4);
    }
    void finish()
    {
        using namespace std::chrono_literals;
        for (int i = 0; i < 4000 && editor.frames_export.status(); ++i) {
            frames(1);
            std::this_thread::sleep_for(1ms);
        }
        frames(2);
        EXPECT_FALSE(editor.frames_export.status());
    }
    // The button at the right of the dialog's foot.
    void agree()
    {
        const glm::vec2 middle = glm::vec2(size_px) / 2.0f, half(300, 171);
        click(glm::round(middle) + half - glm::vec2(24 + 48, 30));
    }
    const ui::Notices::Notice& told() const { return editor.session.notices.all().back(); }
    std::string why(const std::function<void(ExportPlan&)>& change) const
    {
        ExportPlan changed = plan;
        change(changed);
        try {
            wish_of(changed, editor.session);
        } catch (const Rejected& refused) {
            return refused.what();
        }
        return {};
    }
};

TEST(FramesExports, AreTheFilesOfTheCommandLineWhileWorkOnTheSceneGoesOn)
{
    Exported rig;
    const std::string as_it_was = rig.disk.file("as_it_was.trivar");
    fs::copy_file(rig.disk.file("a.trivar"), as_it_was);
    rig.plan.last = 6;
    rig.plan.tolerance = 0.002;
    rig.frames(2);
    rig.agree();
    EXPECT_FALSE(rig.editor.memory.of<ExportDialog>().open);
    rig.editor.session.selected = 2;
    rig.key({'X'}); // as it was when this began: both boxes
    rig.finish();
    EXPECT_EQ(rig.told().title, "Exported 6 frames to a.glb");
    EXPECT_THAT(rig.told().body, HasSubstr("within"));
    fs::rename(as_it_was, rig.disk.file("a.trivar"));
    std::ostringstream out, talk;
    EXPECT_EQ(run_program({"export", rig.disk.file("a.trivar"), "--to", rig.disk.file("b.glb"),
                           "--frames", "1:6", "--epsilon", "0.002"},
                          {out, talk}),
              Status::done);
    EXPECT_TRUE(read_text_file(rig.disk.file("a.glb")) == read_text_file(rig.disk.file("b.glb")));
}

TEST(FramesExports, OfAPointCacheSayHowManyFilesTheyAre)
{
    Exported rig;
    set_kind(rig.plan, 2);
    rig.plan.last = 2;
    rig.frames(2);
    rig.agree();
    rig.finish();
    EXPECT_EQ(rig.told().title, "Exported 2 frames to a.pc2");
    EXPECT_THAT(rig.told().body, HasSubstr("a.Box.pc2 and "));
}

TEST(FramesExports, SayThatTheyWereStoppedAndLeaveNothing)
{
    Exported rig;
    rig.editor.frames_export.begin(wish_of(rig.plan, rig.editor.session));
    rig.editor.frames_export.stop();
    rig.finish();
    EXPECT_EQ(rig.told().title, "The export was stopped");
    EXPECT_FALSE(fs::exists(rig.disk.file("a.glb")));
}

TEST(FramesExports, TellWhatIsNotCertifiedAndGiveAllOfItToRead)
{
    Exported rig;
    rig.editor.memory.of<ExportDialog>().open = false;
    const auto with_keys = [](Id object, const char* parameter, double from, double to) {
        Track track;
        track.parameter = parameter;
        track.keys = {Key(), Key()};
        track.keys[0].frame = 1;
        track.keys[0].value = from;
        track.keys[1].frame = 3;
        track.keys[1].value = to;
        return command_line(Animate{{{object, {track}}}});
    };
    testing::write_file(
        rig.disk.file("pot.trivar"),
        testing::scene_text() + command_line(AddTeapot{}) + command_line(testing::placed(3, 1)) +
            with_keys(2, "placement.width", 0.4, 0.5) + with_keys(3, "placement.width", 0.4, 0.5));
    rig.editor.files.open_scene(rig.disk.file("pot.trivar"));
    rig.wait();
    ask_export_frames(rig.editor);
    EXPECT_EQ(rig.plan.file, rig.disk.file("pot.glb"));
    rig.plan.last = 2;
    rig.plan.tolerance = 0.02;
    rig.editor.memory.of<ExportDialog>().open = false;
    rig.editor.frames_export.begin(wish_of(rig.plan, rig.editor.session));
    rig.finish();
    EXPECT_EQ(rig.told().title, "Exported 2 frames to pot.glb, not all of it certified");
    EXPECT_THAT(rig.told().body, HasSubstr("not certified between them: its placement.width has"));
    EXPECT_THAT(rig.told().body, HasSubstr("2 parts in volumes"));
    ASSERT_EQ(rig.told().actions.size(), 1u);
    EXPECT_EQ(rig.told().actions.front().words, "Read all 2...");
    rig.told().actions.front().act();
    ASSERT_TRUE(rig.editor.frames_export.reading);
    EXPECT_EQ(rig.editor.frames_export.reading->sentences.size(), 2u);
    rig.frames(2);
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.frames_export.reading);
}

TEST(FramesExports, SayWhyNothingWasWritten)
{
    Exported rig;
    ExportWish wish = wish_of(rig.plan, rig.editor.session);
    wish.path = rig.disk.file("no/such/a.glb");
    rig.editor.frames_export.begin(wish);
    rig.finish();
    EXPECT_EQ(rig.told().title, "a.glb was not written");
}

TEST(ExportPlans, HaveTheKindOfTheirFilesEnding)
{
    ExportPlan plan{.file = "out/a.b"};
    EXPECT_EQ(kind_of(plan), -1);
    set_kind(plan, 0);
    EXPECT_EQ(plan.file, "out/a.b.glb");
    set_kind(plan, 3);
    EXPECT_EQ(plan.file, "out/a.b.mdd");
    plan.file = "A.USDA";
    EXPECT_EQ(kind_of(plan), 1);
}

TEST(ExportPlans, ThatMakeNoSenseAreRefusedInASentence)
{
    Exported rig;
    EXPECT_EQ(rig.why([](ExportPlan&) {}), "");
    EXPECT_NE(rig.why([](ExportPlan& p) { p.file.clear(); }), "");
    EXPECT_THAT(rig.why([](ExportPlan& p) { p.file += ".txt"; }), HasSubstr(".glb, .usda"));
    EXPECT_THAT(rig.why([&](ExportPlan& p) { p.file = rig.disk.file("no/a.glb"); }),
                HasSubstr("there is no folder"));
    EXPECT_NE(rig.why([](ExportPlan& p) { p.first = 5, p.last = 4; }), "");
    EXPECT_NE(rig.why([](ExportPlan& p) { p.last = 100000; }), "");
}

TEST(ExportPlans, WriteOverNoModelOfTheScene)
{
    Exported rig;
    rig.agree();
    rig.finish();
    rig.editor.files.import(rig.disk.file("a.glb"));
    rig.wait();
    EXPECT_THAT(rig.why([](ExportPlan&) {}), HasSubstr("a.glb is a model of this scene"));
    EXPECT_EQ(usual_export(rig.editor.session, {}).file, rig.disk.file("a_001.glb"));
}

TEST(ExportDialog, IsOfTheScenesFileAndReplacesOneThatIsThere)
{
    Exported rig;
    EXPECT_EQ(rig.plan.file, rig.disk.file("a.glb"));
    testing::write_file(rig.disk.file("a.glb"), "old");
    EXPECT_TRUE(outlook_of(rig.plan, wish_of(rig.plan, rig.editor.session)).replaces);
    set_kind(rig.plan, 2);
    EXPECT_FALSE(outlook_of(rig.plan, wish_of(rig.plan, rig.editor.session)).replaces);
    testing::write_file(rig.disk.file("a.Box.pc2"), "old");
    EXPECT_TRUE(outlook_of(rig.plan, wish_of(rig.plan, rig.editor.session)).replaces);
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.memory.of<ExportDialog>().open);
    EXPECT_EQ(read_text_file(rig.disk.file("a.glb")), "old");
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/view.h"
#include "editor/actions/file_actions.h"
#include "editor/command_line/command_line.h"
#include "editor/record/recording_wish.h"
#include "tests/editor/boxes.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <map>
#include <sstream>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

// Two boxes, one of which rises from frame 1 to 6, saved, and the plan of a small recording.
struct Recorded : testing::Boxes {
    TemporaryFolder disk;
    RecordPlan plan;
    Recorded()
    {
        Track track;
        track.parameter = "transform.translation.z";
        track.keys = {Key(), Key()};
        track.keys[0].frame = 1;
        track.keys[1].frame = 6;
        track.keys[1].value = 1.5;
        EXPECT_TRUE(editor.session.run(Animate{{{1, {track}}}}));
        Camera camera = editor.session.view.camera;
        EXPECT_TRUE(editor.session.run(KeepView{"picture", camera}));
        editor.session.save_as(disk.file("a.trivar"));
        wait();
        plan = usual_plan(editor.session);
        plan.last = 6;
        plan.width_px = 64;
        plan.height_px = 36;
        plan.level = gpu::Level::draft;
    }
    void begin() { editor.recording.begin(wish_of(plan, editor.session)); }
    void finish()
    {
        using namespace std::chrono_literals;
        for (int i = 0; i < 4000 && editor.recording.running(); ++i) {
            frames(1);
            std::this_thread::sleep_for(1ms);
        }
        EXPECT_FALSE(editor.recording.running());
    }
    const ui::Notices::Notice& told() const { return editor.session.notices.all().back(); }
    std::map<std::string, std::string> files(const std::string& folder) const
    {
        std::map<std::string, std::string> out;
        for (const auto& each : fs::directory_iterator(disk.file(folder)))
            out[each.path().filename()] = read_text_file(each.path());
        return out;
    }
    std::string render(const std::string& to, const std::vector<std::string>& more = {},
                       std::string scene = {}) const
    {
        if (scene.empty()) scene = disk.file("a.trivar");
        std::vector<std::string> words{"render", scene,       "--frames", "1:6",   "--size",
                                       "64x36",  "--quality", "draft",    "--out", disk.file(to)};
        words.insert(words.end(), more.begin(), more.end());
        std::ostringstream out, talk;
        EXPECT_EQ(run_program(words, {out, talk}), Status::done) << talk.str();
        return talk.str();
    }
};

TEST(Recordings, AreThePicturesOfTheCommandLineWhileWorkOnTheSceneGoesOn)
{
    Recorded rig;
    const std::string as_it_was = rig.disk.file("as_it_was.trivar");
    fs::copy_file(rig.disk.file("a.trivar"), as_it_was);
    rig.begin();
    rig.frames(2);
    rig.editor.session.selected = 2;
    rig.key({'X'}); // as it was when this began: both boxes
    EXPECT_EQ(rig.editor.session.document().objects.size(), 1u);
    EXPECT_EQ(rig.editor.session.frame(), 1);
    rig.finish();
    EXPECT_EQ(rig.told().title, "The recording is finished");
    EXPECT_EQ(rig.told().body, "6 frames are in a_frames.");
    const auto files = rig.files("a_frames");
    EXPECT_EQ(files.size(), 6u);
    rig.render("by_line/a.####.png", {}, as_it_was); // last: it takes the context
    EXPECT_TRUE(files == rig.files("by_line"));
    EXPECT_TRUE(files.at("a.0001.png") != files.at("a.0006.png"));
    EXPECT_TRUE(rig.editor.recording.last());
}

TEST(Recordings, ThatWereStoppedAreContinuedHereAndByTheCommandLine)
{
    Recorded rig;
    rig.begin();
    while (!fs::exists(rig.disk.file("a_frames/a.0002.png"))) rig.frames(1);
    rig.editor.recording.stop();
    EXPECT_THAT(rig.told().title, "The recording was stopped");
    rig.wait();
    const auto before = rig.files("a_frames");
    EXPECT_LT(before.size(), 6u);
    const fs::file_time_type written = fs::last_write_time(rig.disk.file("a_frames/a.0001.png"));
    rig.begin();
    rig.finish();
    EXPECT_EQ(rig.files("a_frames").size(), 6u);
    EXPECT_EQ(fs::last_write_time(rig.disk.file("a_frames/a.0001.png")), written);
    EXPECT_THAT(rig.render("a_frames/a.####.png", {"--resume"}), HasSubstr("6 frames, 0 drawn"));
}

TEST(Recordings, FromAnotherViewAreNotContinued)
{
    Recorded rig;
    ASSERT_TRUE(rig.editor.session.run(ForgetView{"picture"}));
    rig.plan.last = 1;
    rig.begin();
    rig.finish();
    const auto before = rig.files("a_frames");
    rig.editor.session.view.camera.eye.x += 2;
    rig.begin();
    rig.finish();
    EXPECT_TRUE(rig.files("a_frames") != before);
}

TEST(Recordings, SayWhereTheirFolderCannotBeWrittenOrVanishes)
{
    Recorded rig;
    rig.plan.folder = rig.disk.file("no/such/folder");
    rig.begin();
    rig.finish();
    EXPECT_EQ(rig.told().title, "The recording has ended");
    EXPECT_THAT(rig.told().body, HasSubstr("cannot be created"));
    rig.plan.folder = rig.disk.file("gone");
    rig.begin();
    while (!fs::exists(rig.disk.file("gone/a.0001.png"))) rig.frames(1);
    fs::remove_all(rig.disk.file("gone"));
    rig.finish();
    EXPECT_EQ(rig.told().title, "The recording has ended");
    EXPECT_THAT(rig.told().body, HasSubstr("a.000"));
}

TEST(Recordings, GoOnWhereTheGraphicsCardIsReset)
{
    Recorded rig;
    rig.begin();
    rig.frames(3);
    rig.screen.lose_context([&] { rig.editor.lose_context(); });
    rig.finish();
    EXPECT_EQ(rig.files("a_frames").size(), 6u);
}

TEST(RecordPlans, ThatMakeNoSenseAreRefusedInASentence)
{
    Recorded rig;
    const auto why = [&](auto&& change) {
        RecordPlan plan = rig.plan;
        change(plan);
        try {
            wish_of(plan, rig.editor.session);
        } catch (const Rejected& refused) {
            return std::string(refused.what());
        }
        return std::string();
    };
    EXPECT_EQ(why([](RecordPlan&) {}), "");
    EXPECT_NE(why([](RecordPlan& p) { p.folder.clear(); }), "");
    EXPECT_NE(why([](RecordPlan& p) { p.width_px = 0; }), "");
    EXPECT_NE(why([](RecordPlan& p) { p.last = 100000; }), "");
    EXPECT_NE(why([](RecordPlan& p) { p.first = 5, p.last = 4; }), "");
    EXPECT_NE(why([](RecordPlan& p) { p.step = 0; }), "");
}

TEST(RecordDialog, IsOpenedByItsKeyAndBeginsARecording)
{
    Recorded rig;
    rig.key({.key = ui::key_f1 + 11, .ctrl = true});
    ASSERT_TRUE(rig.editor.memory.of<RecordDialog>().open);
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.memory.of<RecordDialog>().open);
    ask_record(rig.editor);
    rig.editor.memory.of<RecordDialog>().plan = rig.plan;
    rig.frames(4);
    const glm::vec2 middle = glm::vec2(rig.size_px) / 2.0f, half(300, 202); // the card
    rig.click(glm::round(middle) + half - glm::vec2(24 + 48, 30));
    EXPECT_FALSE(rig.editor.memory.of<RecordDialog>().open);
    ASSERT_TRUE(rig.editor.recording.running());
    action(rig.editor, record_action).run(rig.editor);
    EXPECT_TRUE(rig.editor.memory.of<RecordDialog>().card_hidden);
    rig.finish();
    EXPECT_EQ(rig.files("a_frames").size(), 6u);
}

TEST(RecordDialog, BeginsNothingWhileItsPlanMakesNoSense)
{
    Recorded rig;
    ask_record(rig.editor);
    rig.editor.memory.of<RecordDialog>().plan = rig.plan;
    rig.editor.memory.of<RecordDialog>().plan.folder.clear();
    rig.frames(4);
    const glm::vec2 middle = glm::vec2(rig.size_px) / 2.0f, half(300, 202); // the card
    rig.click(glm::round(middle) + half - glm::vec2(24 + 48, 30));
    EXPECT_TRUE(rig.editor.memory.of<RecordDialog>().open);
    EXPECT_FALSE(rig.editor.recording.running());
}

TEST(RecordDialog, WantsTheScenesFile)
{
    testing::Boxes rig;
    rig.key({.key = ui::key_f1 + 11, .ctrl = true});
    EXPECT_FALSE(rig.editor.memory.of<RecordDialog>().open);
    EXPECT_EQ(rig.editor.session.notices.all().back().title, "The scene is not saved yet");
}

} // namespace
} // namespace trivar

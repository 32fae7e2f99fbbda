// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/placement/place.h"
#include "core/placement/placement.h"
#include "editor/help/tutorial.h"

#include "core/base/text.h"
#include "core/evaluation/evaluate.h"
#include "core/scene/log.h"
#include "editor/actions/help_actions.h"
#include "editor/actions/use_keys.h"
#include "editor/actions/words_with_keys.h"
#include "editor/session/recent_scenes.h"
#include "editor/words/markdown.h"
#include "tests/editor/help/unknown_actions.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig;
using testing::TemporaryFolder;

std::vector<std::string> all_tutorials()
{
    return tutorials_in(std::string(TRIVAR_SOURCE_DIR) + "/assets/tutorials");
}

// Three boxes that are moved by and by, each with words.
std::string small_tutorial(const TemporaryFolder& folder)
{
    const std::string path = folder.file("two_boxes.trivar");
    AddBox second;
    second.transform.translation = {2, 0, 0};
    SetTransform move{1, {}};
    move.transform.translation = {0, 0, 4};
    std::ofstream(path) << log_header() << command_line(AddBox{}, "A box.")
                        << command_line(second, "Another.") << command_line(move, "Up, by @Move.");
    return path;
}

struct Lesson : Rig {
    explicit Lesson(const std::string& path)
    {
        add_tutorials(editor, {path});
        action(editor, scene_title(path)).run(editor);
        wait();
    }
    std::string words() const
    {
        std::string words;
        for (const Block& block : blocks_of(editor.tutorial.note(editor.session)))
            words += plain_text(with_keys(editor, block.runs));
        return words;
    }
    double height() const { return object(editor.session.document(), 1).transform.translation.z; }
};

TEST(Tutorial, EveryOneReplaysWithoutANoticeAndHasANoteOnEachLine)
{
    std::vector<std::string> titles;
    const Rig rig;
    for (const std::string& path : all_tutorials()) {
        titles.push_back(scene_title(path));
        const SceneFile scene = SceneFile::copy_of(path);
        const auto assets = std::make_shared<const AssetStore>(scene.folder());
        Evaluator evaluator(assets);
        for (const History::Step& step : scene.history().steps()) {
            EXPECT_FALSE(step.note.empty()) << path << ": " << to_json_line(step.command);
            EXPECT_THAT(testing::unknown_actions(rig.editor, step.note), IsEmpty()) << path;
            const Evaluation evaluated = evaluator(step.result);
            for (const auto& [id, effects] : evaluated.objects) {
                EXPECT_THAT(effects->notices, IsEmpty()) << path << ": " << step.note;
                if (!effects->placement) continue;
                EXPECT_THAT(effects->placement->report.all_notices(), IsEmpty())
                    << path << ": " << step.note;
            }
        }
    }
    EXPECT_THAT(titles, ElementsAre("First stroke", "One on another", "Arranging", "In a lattice",
                                    "Painting tiles"));
}

TEST(Tutorial, GoesForthAndBackByKeysAndDoesNothingToItsScene)
{
    const TemporaryFolder folder;
    const std::string path = small_tutorial(folder), text = read_text_file(path);
    Lesson lesson(path);
    const auto step = [&] { return lesson.editor.tutorial.step(lesson.editor.session); };
    EXPECT_EQ(step(), 1u);
    EXPECT_EQ(lesson.words(), "A box.");
    lesson.key({ui::key_right});
    lesson.wait();
    lesson.key({ui::key_right});
    EXPECT_EQ(step(), 3u);
    EXPECT_EQ(lesson.words(), "Up, by G.");
    lesson.key({ui::key_left});
    lesson.key({ui::key_left});
    EXPECT_EQ(step(), 1u);
    EXPECT_EQ(lesson.editor.session.document().objects.size(), 1u);
    EXPECT_TRUE(lesson.editor.session.scene().as_opened());
    lesson.key({ui::key_escape});
    EXPECT_FALSE(lesson.editor.tutorial.runs(lesson.editor.session));
    EXPECT_EQ(read_text_file(path), text);
}

TEST(Tutorial, ItsButtonsAreCoveredByNoNotice)
{
    const TemporaryFolder folder;
    Lesson lesson(small_tutorial(folder));
    lesson.editor.session.notices.say(ui::NoticeKind::warning, "There is nothing to place it on");
    lesson.frames();
    const ui::Rect view = lesson.layout().view; // the card is nearly as wide
    lesson.click(view.hi - glm::vec2(50, 48));
    EXPECT_EQ(lesson.editor.tutorial.step(lesson.editor.session), 2u);
}

TEST(Tutorial, ShowsAGestureOnItsWayUnlessMotionIsReduced)
{
    const TemporaryFolder folder;
    Lesson lesson(small_tutorial(folder));
    lesson.key({ui::key_right});
    lesson.wait();
    // The tutorial runs on a clock of its own: the window jumps where its pictures take long.
    Session& session = lesson.editor.session;
    lesson.editor.tutorial.next(session);
    double between = 0;
    for (int i = 0; i < 2000 && lesson.height() < 4; ++i) {
        lesson.editor.tutorial.advance(session, i / 60.0, false);
        while (!session.up_to_date()) {
            session.poll();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (lesson.height() > 0 && lesson.height() < 4) between = lesson.height();
    }
    EXPECT_GT(between, 0);
    EXPECT_LT(between, 4);
    EXPECT_EQ(lesson.height(), 4);
    lesson.key({ui::key_left});
    EXPECT_EQ(lesson.height(), 0);
    lesson.editor.preferences.reduced_motion = true;
    lesson.key({ui::key_right});
    EXPECT_EQ(lesson.height(), 4);
}

TEST(Tutorial, AStepOfOnesOwnMakesItAnOrdinaryScene)
{
    const TemporaryFolder folder;
    Lesson lesson(small_tutorial(folder));
    Session& session = lesson.editor.session;
    ASSERT_TRUE(session.run(AddSphere{}));
    lesson.frames();
    EXPECT_EQ(lesson.words(), "");
    EXPECT_FALSE(is_enabled(lesson.editor, action(lesson.editor, tutorial_next)));
    session.undo();
    EXPECT_EQ(lesson.steps(), 1u);
    EXPECT_FALSE(session.scene().as_opened());
}

TEST(Tutorial, AStrokeGrowsFromItsBeginningAndEndsAsItWas)
{
    Place place{1, {}, {}, {}};
    for (int i = 0; i < 50; ++i) place.sketch.samples.push_back({{i, 0}, i * 0.01, 1});
    const auto samples = [&](double done) {
        return part_of(place, {}, done)->get<Place>().sketch.samples.size();
    };
    EXPECT_EQ(samples(0), 3u);
    EXPECT_EQ(samples(0.5), 25u);
    EXPECT_EQ(Command(place), *part_of(place, {}, 1));
    EXPECT_FALSE(part_of(AddBox{}, {}, 0.5));
}

TEST(Tutorial, WordsNameTheKeyThatIsChosenAtPresentOrTheMenu)
{
    Rig rig;
    const auto shown = [&](const std::string& words) {
        return with_keys(rig.editor, blocks_of(words).front().runs);
    };
    using enum ui::Run::Kind;
    EXPECT_THAT(shown("Press @Save as..., then go"),
                ElementsAre(ui::Run{plain, "Press "}, ui::Run{key, "Ctrl Shift S"},
                            ui::Run{plain, ", then go"}));
    use_keys(rig.editor.actions, {{"Place", {}}});
    EXPECT_THAT(shown("@Place"), ElementsAre(ui::Run{strong, "Tools > Place"}));
    EXPECT_THAT(shown("me@home"), ElementsAre(ui::Run{plain, "me@home"}));
    EXPECT_THAT(testing::unknown_actions(rig.editor, "me@home, @Plaice."),
                ElementsAre("home", "Plaice"));
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/recent_scenes.h"
#include "editor/session/samples.h"

#include "core/scene/log.h"
#include "editor/actions/help_actions.h"
#include "editor/actions/start_card.h"
#include "editor/panels/help/welcome.h"
#include "editor/session/scene_names.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre;
using testing::Rig;
using testing::TemporaryFolder;

std::time_t at(int year, int month, int day, int hour, int minute)
{
    std::tm tm{};
    tm.tm_year = year - 1900;
    tm.tm_mon = month - 1;
    tm.tm_mday = day;
    tm.tm_hour = hour;
    tm.tm_min = minute;
    tm.tm_isdst = -1;
    return std::mktime(&tm);
}

TEST(RecentScenes, SayWhenAsOneWouldSayItNow)
{
    const std::time_t now = at(2026, 3, 1, 0, 30);
    EXPECT_EQ(day_words(at(2026, 3, 1, 0, 5), now), "Today, 00:05");
    EXPECT_EQ(day_words(at(2026, 2, 28, 23, 59), now), "Yesterday");
    EXPECT_EQ(day_words(at(2026, 2, 27, 12, 0), now), "27 February");
    EXPECT_EQ(day_words(at(2025, 3, 1, 12, 0), now), "1 March 2025");
    EXPECT_EQ(day_words(at(2025, 12, 31, 12, 0), at(2026, 1, 1, 1, 0)), "Yesterday");
}

TEST(RecentScenes, ForgetWhatWasFoundAgainElsewhere)
{
    const TemporaryFolder folder;
    std::ofstream(folder.file("b.trivar")) << " ";
    std::vector<std::string> paths{folder.file("a.trivar"), "/gone/a.trivar", "/gone/b.trivar",
                                   folder.file("b.trivar")};
    forget_moved(paths, folder.file("a.trivar"));
    EXPECT_THAT(paths,
                ElementsAre(folder.file("a.trivar"), "/gone/b.trivar", folder.file("b.trivar")));
}

TEST(StartCard, LeavesAtTheFirstActionAndComesBackByHelp)
{
    Rig rig;
    rig.frames();
    EXPECT_TRUE(shows_welcome(rig.editor));
    action(rig.editor, "Box").run(rig.editor);
    EXPECT_FALSE(shows_welcome(rig.editor));
    rig.editor.session.undo();
    EXPECT_FALSE(shows_welcome(rig.editor));
    action(rig.editor, "Start card").run(rig.editor);
    rig.frames();
    EXPECT_TRUE(shows_welcome(rig.editor));
    rig.key({ui::key_escape});
    EXPECT_FALSE(shows_welcome(rig.editor));
}

TEST(StartCard, ItsSamplesOpenByTheirNamesToo)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("scenes"));
    const std::string path = folder.file("scenes/stacked.trivar");
    std::ofstream(path) << log_header() << command_line(AddBox{});
    Rig rig;
    rig.editor.files.samples = {path};
    add_samples(rig.editor);
    action(rig.editor, "Snakes on a crocodile").run(rig.editor);
    rig.wait();
    EXPECT_EQ(title_of(rig.editor.session.scene()), "Snakes on a crocodile");
    EXPECT_EQ(sample_title("/share/tutorials/first_stroke.trivar"), "First stroke");
}

TEST(StartCard, IsNotThereOverANewScene)
{
    Rig rig;
    rig.frames();
    rig.key({.key = 'N', .ctrl = true});
    EXPECT_FALSE(shows_welcome(rig.editor));
}

TEST(StartCard, ItsEntriesAreReachedAndChosenByKeys)
{
    Rig rig({1024, 700});
    rig.frames();
    auto& card = rig.editor.start_card;
    EXPECT_EQ(card.at, -1);
    const int frame = rig.editor.session.frame();
    for (const int at : {0, 1, 2}) {
        rig.key({ui::key_tab});
        EXPECT_EQ(card.at, at);
    }
    rig.key({ui::key_up});
    EXPECT_EQ(card.at, 1);
    rig.key({.key = ui::key_tab, .shift = true});
    EXPECT_EQ(card.at, 0);
    rig.key({ui::key_right});
    EXPECT_EQ(rig.editor.session.frame(), frame) << "the arrows are the card's";
    rig.key({ui::key_down});
    rig.key({ui::key_enter}); // Open...
    EXPECT_TRUE(rig.editor.files.asking());
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.files.asking());
    rig.key({.key = ui::key_tab, .shift = true});
    rig.key({ui::key_enter}); // New scene
    EXPECT_FALSE(shows_welcome(rig.editor));
}

TEST(StartCard, ArrowsGoToWhatIsNearestThatWay)
{
    // Two wide rows, and beside them two columns.
    const std::vector<ui::Rect> entries{
        ui::rect_at({0, 0}, {100, 30}), ui::rect_at({0, 40}, {100, 30}),
        ui::rect_at({120, 0}, {50, 60}), ui::rect_at({180, 0}, {50, 60}),
        ui::rect_at({120, 80}, {50, 60})};
    EXPECT_EQ(next_entry(entries, 0, {0, 1}), 1);
    EXPECT_EQ(next_entry(entries, 1, {1, 0}), 2);
    EXPECT_EQ(next_entry(entries, 2, {1, 0}), 3);
    EXPECT_EQ(next_entry(entries, 2, {0, 1}), 4);
    EXPECT_EQ(next_entry(entries, 4, {-1, 0}), 1);
    EXPECT_EQ(next_entry(entries, 3, {1, 0}), 3) << "there is none";
}

} // namespace
} // namespace trivar

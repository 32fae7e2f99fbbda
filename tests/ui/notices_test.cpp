// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"
#include "ui/notices.h"

#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

using ::testing::ElementsAre, ::testing::SizeIs;

std::vector<std::string> titles(const Notices& notices)
{
    std::vector<std::string> result;
    for (const Notices::Notice& each : notices.all()) result.push_back(each.title);
    return result;
}

TEST(Notices, OfOneTopicTakeThePlaceOfEachOther)
{
    Notices notices;
    notices.say(NoticeKind::warning, "Nothing was placed", "Draw longer", "step");
    notices.say(NoticeKind::good, "Saved");
    notices.say(NoticeKind::warning, "Snake was placed", "A gap is bridged", "step");
    EXPECT_THAT(titles(notices), ElementsAre("Saved", "Snake was placed"));
    notices.forget("step");
    EXPECT_THAT(titles(notices), ElementsAre("Saved"));
}

TEST(Notices, SayWhatBelongsTogetherInLinesUnderOneTitle)
{
    Notices notices;
    notices.say_all(NoticeKind::warning, "snake was placed", {"two rays hit nothing", "It folds."});
    ASSERT_THAT(notices.all(), SizeIs(1));
    EXPECT_EQ(notices.all()[0].title, "Snake was placed");
    EXPECT_EQ(notices.all()[0].body, "Two rays hit nothing.\nIt folds.");
}

TEST(Notices, AreSentencesWhateverTheNamesInThem)
{
    Notices notices;
    notices.say(NoticeKind::good, "\x1b[2J\n\xff was placed",
                "On " + std::string(3000, 'a') + "\nAs before");
    ASSERT_THAT(notices.all(), SizeIs(1));
    EXPECT_EQ(notices.all()[0].title, "?[2J?? was placed");
    const std::string& body = notices.all()[0].body;
    EXPECT_LE(body.find('\n'), 400u);
    EXPECT_TRUE(body.ends_with("aaa\nAs before.")) << body;
}

TEST(Notices, OfErrorsLeaveButForThoseWithARemedy)
{
    Notices notices;
    notices.say(NoticeKind::error, "It was not read");
    notices.say(NoticeKind::error, "A file is missing", {}, {}, {{"Find...", [] {}}});
    HeadlessFrames screen({600, 400});
    const auto draw = [&](Frame& frame) {
        frame.time_s = frame.time_s * 60; // minutes
        notices.draw(frame, {{0, 0}, {600, 400}});
    };
    screen.frames(90, draw);
    EXPECT_THAT(titles(notices), ElementsAre("A file is missing"));
}

TEST(Notices, SaidTwiceCountUp)
{
    Notices notices;
    for (int i = 0; i < 3; ++i) notices.say(NoticeKind::warning, "Locked");
    ASSERT_THAT(notices.all(), SizeIs(1));
    EXPECT_EQ(notices.all()[0].count, 3);
}

} // namespace
} // namespace trivar::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"
#include "ui/timing_graph.h"
#include "ui/timing_overlay.h"

#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

using ::testing::HasSubstr, ::testing::Not;

TimingHistory pictures_of(int count)
{
    TimingHistory history;
    for (int i = 1; i <= count; ++i)
        history.add({{{{"lift", 1.0 * i}}}, {{{"surfaces", 2.0 * i}, {"light", 1.0 * i}}}});
    return history;
}

TEST(TimingHistory, KeepsTheLastPicturesAndTheirNumbers)
{
    const TimingHistory history = pictures_of(100);
    EXPECT_EQ(history.count(), 100);
    EXPECT_EQ(history.pictures().size(), TimingHistory::length);
    EXPECT_EQ(history.find(20), nullptr);
    ASSERT_NE(history.find(21), nullptr);
    EXPECT_EQ(total_ms(*history.find(21)), 4 * 21);
    EXPECT_EQ(history.find(101), nullptr);
    EXPECT_EQ(history.find(0), nullptr);
}

TEST(TimingHistory, MedianIsOfTheLastFifteen)
{
    EXPECT_EQ(TimingHistory().median_ms(), 0);
    EXPECT_EQ(pictures_of(3).median_ms(), 4 * 2);
    EXPECT_EQ(pictures_of(100).median_ms(), 4 * 93);
}

TEST(TimingGraph, TheNewestPictureIsAtTheRight)
{
    const TimingHistory history = pictures_of(10);
    const Rect graph{{100, 0}, {100 + 4.0f * TimingHistory::length, 50}};
    EXPECT_EQ(picture_at(history, graph, graph.hi.x - 1), 10);
    EXPECT_EQ(picture_at(history, graph, graph.hi.x - 39), 1);
    EXPECT_EQ(picture_at(history, graph, graph.hi.x - 41), 0);
    EXPECT_EQ(picture_at(history, graph, graph.hi.x + 1), 0);
}

TEST(TimingCard, StaysInTheRoomThatItHasAndLeavesOutTheRest)
{
    HeadlessFrames screen({600, 500});
    const TimingHistory history = pictures_of(20);
    Timings evaluation;
    for (const char* stage : {"lift", "springs", "deform"}) evaluation.add(stage, 2);
    const std::vector<TimedWay> ways{{"Processor", "", true, 2.0, 100'000, ""}};
    TimingView view;
    view.open = true;
    float highest = 0;
    for (const glm::vec2 size :
         {glm::vec2(500, 40), {100, 400}, {500, 150}, {260, 220}, {500, 400}}) {
        const Rect room = rect_at({20, 20}, size);
        std::optional<Rect> card;
        screen.frames(2, [&](Frame& frame) {
            card = draw_timing(frame.theme, room,
                               {history, evaluation, {}, 1, 1, ways, "3 of 5 tiles seen"}, view,
                               "F10");
        });
        EXPECT_EQ(card.has_value(), size.x > 150 && size.y > 100);
        if (!card) continue;
        EXPECT_TRUE(room.contains(card->lo) && room.contains(card->hi - 1.0f)) << size.y;
        EXPECT_GE(card->height(), highest);
        highest = card->height();
    }
    EXPECT_GT(highest, 220);
}

TEST(TimingText, NamesEveryStageAndItsThroughput)
{
    const TimingHistory history = pictures_of(2);
    Timings evaluation;
    evaluation.add("deform", 2, 100'000);
    const std::vector<TimedWay> ways{{"Processor", "", true, 2.0, 100'000, "0.00°"},
                                     {"One phase", "", false, {}, 0, ""}};
    const std::string text =
        timing_text({history, evaluation, {}, 3 << 20, 2 << 20, ways, "3 of 5 tiles seen"});
    EXPECT_THAT(text, Not(HasSubstr("One phase")));
    for (const char* part :
         {"Median", "deform", "100000 vertices, 50.0 million a second", "Deformed by Processor",
          "off by 0.00°", "surfaces", "light", "3.0 MB", "2.0 MB", "3 of 5 tiles seen"})
        EXPECT_THAT(text, HasSubstr(part));
}

} // namespace
} // namespace trivar::ui

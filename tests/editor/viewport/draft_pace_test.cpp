// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/draft_pace.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using gpu::Level;

// Pictures for so many seconds: of the level's own time, a part of which grows with the area.
struct Machine {
    double fixed_ms, draft_ms, standard_ms;
    double now_s = 0;
    int changes = 0;
    void draw(DraftPace& pace, double seconds)
    {
        for (const double end = now_s + seconds; now_s < end;) {
            const double area = pace.scale() * pace.scale();
            const double level_ms = pace.level() == Level::draft ? draft_ms : standard_ms;
            const double took = fixed_ms + level_ms * area, scale = pace.scale();
            const Level level = pace.level();
            now_s += took / 1000;
            pace.drew(took, now_s);
            changes += pace.scale() != scale || pace.level() != level ? 1 : 0;
        }
    }
};

TEST(DraftPace, DrawsSmallerUntilDraftsKeepUp)
{
    Machine machine{10, 100, 0};
    DraftPace pace(60, Level::draft);
    machine.draw(pace, 8);
    EXPECT_LT(pace.scale(), 1);
    EXPECT_LE(10 + 100 * pace.scale() * pace.scale(), 1.25 * 60);
    const double kept = pace.scale();
    machine.draw(pace, 8);
    EXPECT_EQ(pace.scale(), kept) << "it settles";
}

TEST(DraftPace, NeverDrawsSmallerThanHalfHoweverLongItTakes)
{
    Machine machine{5000, 100, 0};
    DraftPace pace(60, Level::draft);
    machine.draw(pace, 200);
    EXPECT_EQ(pace.scale(), 0.5);
}

TEST(DraftPace, DrawsLargerAgainWhereThereIsTimeToSpare)
{
    Machine machine{1, 10, 0};
    DraftPace pace(60, Level::draft, 0.5);
    machine.draw(pace, 20);
    EXPECT_EQ(pace.scale(), 1);
    EXPECT_EQ(pace.level(), Level::draft) << "that is the most this machine is asked for";
}

TEST(DraftPace, IsNotDisturbedByOneSlowDraft)
{
    double now_s = 0;
    DraftPace pace(60, Level::draft);
    for (int i = 0; i < 100; ++i) pace.drew(i % 7 == 3 ? 900 : 40, now_s += 0.05);
    EXPECT_EQ(pace.scale(), 1);
}

TEST(DraftPace, TakesTheLevelDownBeforeTheSizeAndDoesNotTryItAgain)
{
    Machine machine{1, 5, 40};
    DraftPace pace(16, Level::standard);
    machine.draw(pace, 3);
    EXPECT_EQ(pace.level(), Level::draft);
    EXPECT_EQ(pace.scale(), 1);
    machine.draw(pace, 60);
    EXPECT_EQ(pace.level(), Level::draft);
    EXPECT_EQ(machine.changes, 1);
}

TEST(DraftPace, KeepsTheLevelOfAMachineThatIsQuickEnough)
{
    Machine machine{1, 2, 9};
    DraftPace pace(16, Level::standard);
    machine.draw(pace, 30);
    EXPECT_EQ(pace.level(), Level::standard);
    EXPECT_EQ(machine.changes, 0);
}

TEST(DraftPace, ChangesAtMostOnceASecondAndMindsNoTimeThatWasNotMeasured)
{
    Machine machine{0, 400, 0};
    DraftPace pace(16, Level::draft);
    machine.draw(pace, 4);
    EXPECT_LE(machine.changes, 4);
    DraftPace unmeasured(16, Level::standard);
    for (int i = 0; i < 1000; ++i) unmeasured.drew(0, i * 0.1);
    EXPECT_EQ(unmeasured.level(), Level::standard);
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/draft_pace.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// Drafts of `ms` at full size, a part of which grows with the area, for so many seconds.
void draw_for(DraftPace& pace, double seconds, double fixed_ms, double area_ms, double& now_s)
{
    for (const double end = now_s + seconds; now_s < end;) {
        const double took = fixed_ms + area_ms * pace.scale() * pace.scale();
        now_s += took / 1000;
        pace.drew(took, now_s);
    }
}

TEST(DraftPace, DrawsSmallerUntilDraftsKeepUp)
{
    double now_s = 0;
    DraftPace pace(60);
    draw_for(pace, 5, 10, 100, now_s);
    EXPECT_LT(pace.scale(), 1);
    EXPECT_LE(10 + 100 * pace.scale() * pace.scale(), 1.25 * 60);
    const double kept = pace.scale();
    draw_for(pace, 5, 10, 100, now_s);
    EXPECT_EQ(pace.scale(), kept) << "it settles";
}

TEST(DraftPace, NeverDrawsSmallerThanHalfHoweverLongItTakes)
{
    double now_s = 0;
    DraftPace pace(60);
    draw_for(pace, 100, 5000, 100, now_s);
    EXPECT_EQ(pace.scale(), 0.5);
}

TEST(DraftPace, DrawsLargerAgainWhereThereIsTimeToSpare)
{
    double now_s = 0;
    DraftPace pace(60, 0.5);
    draw_for(pace, 10, 1, 10, now_s);
    EXPECT_EQ(pace.scale(), 1);
}

TEST(DraftPace, IsNotDisturbedByOneSlowDraft)
{
    double now_s = 0;
    DraftPace pace(60);
    for (int i = 0; i < 100; ++i) pace.drew(i % 7 == 3 ? 900 : 40, now_s += 0.05);
    EXPECT_EQ(pace.scale(), 1);
}

} // namespace
} // namespace trivar

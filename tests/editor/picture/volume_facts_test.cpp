// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_facts.h"

#include "ui/theme.h"

#include <chrono>
#include <gtest/gtest.h>

namespace trivar {
namespace {

// A box of n x 8 x 8 control points; folded, every second layer of them lies behind the next.
EvaluatedObject box_of(int n, bool folded)
{
    Lattice box = lattice_at_rest(
        {Knots::uniform(3, n), Knots::uniform(3, 8), Knots::uniform(3, 8)}, glm::dmat4(1));
    for (int i = 0; folded && i < n; i += 2)
        for (int j = 0; j < 8; ++j)
            for (int k = 0; k < 8; ++k)
                box.displacement.points[box.displacement.index(i, j, k)].x = 3.0 / n;
    EvaluatedObject out;
    out.placement = make_ref(
        Placement{Surface<glm::dvec3>{{box.displacement.axes[0], box.displacement.axes[1]}, {}},
                  box,
                  {},
                  {},
                  {},
                  0,
                  0,
                  {}});
    return out;
}

// Draws nothing until it is known.
std::vector<gpu::Translucent> folds(VolumeFacts& facts, const EvaluatedObject& of)
{
    const ui::Palette color = ui::dark_palette();
    facts.folds(of, color);
    while (facts.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return facts.folds(of, color);
}

TEST(VolumeFacts, ShowTheFoldsOfSmallVolumesAndOfLargeOnes)
{
    for (const int n : {20, 1600}) { // 1280 and 102,400 points
        VolumeFacts facts;
        const EvaluatedObject good = box_of(n, false), folded = box_of(n, true);
        EXPECT_TRUE(folds(facts, good).empty());
        ASSERT_NE(facts.verdicts(good), nullptr);
        EXPECT_TRUE(facts.verdicts(good)->good());
        EXPECT_NE(facts.deviations(good), nullptr);
        const std::vector<gpu::Translucent> veils = folds(facts, folded);
        ASSERT_FALSE(veils.empty());
        EXPECT_FALSE(facts.verdicts(folded)->good());
    }
}

TEST(VolumeFacts, SayWhatTheColoursOfTheFoldsMean)
{
    VolumeFacts facts;
    const ui::Palette color = ui::dark_palette();
    EXPECT_TRUE(facts.fold_marks(box_of(20, false), color).empty());
    const EvaluatedObject folded = box_of(20, true);
    const std::vector<FoldMark> marks = facts.fold_marks(folded, color);
    ASSERT_EQ(marks.size(), folds(facts, folded).size());
    ASSERT_FALSE(marks.empty());
    EXPECT_EQ(marks.front().color, color.fold);
    EXPECT_EQ(marks.front().words, "The volume folds here");
}

TEST(VolumeFacts, LookForOverlapOnlyWhereThatIsAskedFor)
{
    VolumeFacts facts;
    const EvaluatedObject box = box_of(20, false);
    folds(facts, box);
    EXPECT_EQ(facts.known(), 1);
    facts.overlap(box);
    while (facts.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_NE(facts.overlap(box), nullptr);
    EXPECT_EQ(facts.overlap(box)->verdict, Verdict::proven_good);
    EXPECT_TRUE(facts.meeting(box, ui::dark_palette()).empty());
    EXPECT_EQ(facts.known(), 3);
}

TEST(VolumeFacts, GoOnToWhatIsLookedAtNow)
{
    VolumeFacts facts;
    const EvaluatedObject large = box_of(1600, true), small = box_of(20, false);
    facts.overlap(large);
    EXPECT_TRUE(facts.busy());
    facts.overlap(small);
    while (facts.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_NE(facts.overlap(small), nullptr);
    EXPECT_EQ(facts.overlap(small)->verdict, Verdict::proven_good);
    EXPECT_EQ(facts.overlap(large), nullptr) << "it is looked for anew";
    EXPECT_TRUE(facts.busy()); // and given up when they go
}

} // namespace
} // namespace trivar

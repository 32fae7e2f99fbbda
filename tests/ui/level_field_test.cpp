// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_field.h"

#include "tests/ui/field_rig.h"
#include "ui/keys.h"

#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

// A histogram of values from 0 to 284, 300 wide at (20, 20): a pixel per value from x = 28 on.
struct LevelRig : testing::FieldRig {
    LevelRig() : FieldRig({360, 200}) {}
    std::vector<std::uint64_t> counts{5, 9, 3, 1};
    std::vector<glm::dvec2> curve{{0, 9}, {100, 1}, {200, 1}, {284, 0}};
    std::vector<double> snaps{100, 200};
    std::vector<LevelMark> marks{{.value = 50, .words = "50"}, {.value = 250, .words = "250"}};
    Edit draw(const Theme& theme) override
    {
        return level_field(theme, "levels", marks, chosen,
                           {.counts = counts,
                            .lo = 0,
                            .hi = 284,
                            .height = 116,
                            .curve = curve,
                            .strip = 30,
                            .snaps = snaps},
                           300);
    }
    static glm::vec2 at(float value) { return {28 + value, 60}; }
    void drag(float from, float to, bool let_go = true)
    {
        FieldRig::drag(at(from), at(to), let_go);
    }
};

TEST(Snapping, TakesTheNearestValueWithinReach)
{
    const std::vector<double> to{10, 12, 20};
    EXPECT_EQ(snapped(to, 11.2, 2), 12);
    EXPECT_EQ(snapped(to, 10.8, 2), 10);
    EXPECT_EQ(snapped(to, 15.5, 2), 15.5);
    EXPECT_EQ(snapped(to, 22, 2), 20);
    EXPECT_EQ(snapped({}, 11, 2), 11);
}

TEST(LevelField, AMarkIsDraggedAndNoOtherMoves)
{
    LevelRig rig;
    rig.drag(50, 80);
    EXPECT_EQ(rig.chosen, 0);
    EXPECT_NEAR(rig.marks[0].value, 80, 1);
    EXPECT_EQ(rig.marks[1].value, 250);
    EXPECT_GT(rig.changes, 1);
}

TEST(LevelField, ADragHaltsAtAValueToSnapToUnlessCtrlIsHeld)
{
    LevelRig rig;
    rig.drag(50, 97);
    EXPECT_EQ(rig.marks[0].value, 100);
    rig.drag(100, 110);
    EXPECT_NEAR(rig.marks[0].value, 110, 1) << "it goes on beyond";
    rig.screen.input().push(press_key(key_left_control));
    rig.drag(110, 103);
    EXPECT_NEAR(rig.marks[0].value, 103, 1);
}

TEST(LevelField, EscapeEndsTheDrag)
{
    LevelRig rig;
    rig.drag(250, 230, false);
    rig.screen.input().push(press_key(key_escape));
    rig.screen.frames(3, rig.body());
    EXPECT_EQ(rig.cancels, 1);
}

} // namespace
} // namespace trivar::ui

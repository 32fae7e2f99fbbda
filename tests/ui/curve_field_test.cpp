// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/curve_field.h"

#include "tests/ui/field_rig.h"
#include "ui/keys.h"

#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

// A curve 300 wide at (20, 20). Its values go to 2, so the picture is 256 x 84 from (54, 30).
struct CurveRig : testing::FieldRig {
    CurveRig() : FieldRig({360, 180}) {}
    std::vector<glm::dvec2> points{{0, 1}, {0.5, 1.5}, {1, 1}};
    Edit draw(const Theme& theme) override
    {
        const auto straight = [&](double t) { return 1 + 0 * t; };
        return curve_field(theme, "curve", points, chosen, {.at = straight, .lo = 0.1, .hi = 5},
                           300);
    }
    static glm::vec2 seen(glm::dvec2 p) { return {54 + 256 * p.x, 114 - 42 * p.y}; }
    void ctrl_click(glm::vec2 at)
    {
        screen.input().push(press_key(key_left_control));
        drag(at, at);
        screen.input().push(press_key(key_left_control, false));
        screen.frames(2, body());
    }
};

TEST(CurveField, APointIsDraggedBetweenItsNeighbours)
{
    CurveRig rig;
    rig.drag(CurveRig::seen({0.5, 1.5}), CurveRig::seen({0.75, 0.5}));
    EXPECT_EQ(rig.chosen, 1);
    EXPECT_NEAR(rig.points[1].x, 0.75, 0.01);
    EXPECT_NEAR(rig.points[1].y, 0.5, 0.03);
    rig.points = {{0, 1}, {0.5, 1.5}, {1, 1}};
    rig.drag(CurveRig::seen({0.5, 1.5}), CurveRig::seen({2, 1}));
    EXPECT_NEAR(rig.points[1].x, 0.99, 1e-9);
    rig.points = {{0, 1}, {0.5, 1.5}, {1, 1}};
    rig.drag(CurveRig::seen({0, 1}), CurveRig::seen({0.4, -3}));
    EXPECT_EQ(rig.points[0], glm::dvec2(0, 0.1)); // an end keeps its place, a value its range
}

TEST(CurveField, DelTakesTheChosenPointAwayAndIsHeardByNobodyElse)
{
    CurveRig rig;
    rig.drag(CurveRig::seen({0, 1}), CurveRig::seen({0, 1}));
    const auto strike_del = [&] {
        rig.screen.input().push(press_key(key_delete));
        rig.screen.input().push(press_key(key_delete, false));
        rig.screen.frames(3, rig.body());
    };
    strike_del();
    EXPECT_EQ(rig.points.size(), 3u); // an end
    EXPECT_TRUE(rig.screen.input().keeps(key_delete));
    rig.drag(CurveRig::seen({0.5, 1.5}), CurveRig::seen({0.5, 1.5}));
    strike_del();
    EXPECT_EQ(rig.points, (std::vector<glm::dvec2>{{0, 1}, {1, 1}}));
    EXPECT_EQ(rig.chosen, -1);
    rig.screen.input().push(move_to({350, 170}));
    rig.screen.frames(3, rig.body());
    EXPECT_FALSE(rig.screen.input().keeps(key_delete));
}

TEST(CurveField, CtrlClickAddsAPointOrTakesItAway)
{
    CurveRig rig;
    rig.ctrl_click(CurveRig::seen({0.25, 0.6}));
    ASSERT_EQ(rig.points.size(), 4u);
    EXPECT_NEAR(rig.points[1].x, 0.25, 0.01);
    EXPECT_NEAR(rig.points[1].y, 0.6, 0.03);
    EXPECT_EQ(rig.chosen, 1);
    rig.ctrl_click(CurveRig::seen(rig.points[1]));
    EXPECT_EQ(rig.points.size(), 3u);
    rig.ctrl_click(CurveRig::seen({0, 1})); // an end stays
    EXPECT_EQ(rig.points.size(), 3u);
}

TEST(CurveField, AClickChangesNothing)
{
    CurveRig rig;
    rig.drag(CurveRig::seen({0.5, 1.5}), CurveRig::seen({0.5, 1.5}));
    EXPECT_EQ(rig.chosen, 1);
    EXPECT_EQ(rig.changes, 0);
}

} // namespace
} // namespace trivar::ui

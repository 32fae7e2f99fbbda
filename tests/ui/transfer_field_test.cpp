// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/transfer_field.h"

#include "tests/ui/field_rig.h"
#include "ui/keys.h"

#include <cmath>
#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

// A function over values from 0 to 284, 300 wide at (20, 20): a pixel per value from x = 28 on, and
// opacities from y = 114 up to y = 28.
struct TransferRig : testing::FieldRig {
    TransferRig() : FieldRig({360, 200}) {}
    std::vector<std::uint64_t> counts{5, 9, 3, 1};
    std::vector<TransferPoint> points{
        {50, {1, 0, 0}, 0}, {100, {1, 0, 0}, 0.25}, {200, {0, 0, 1}, 0.25}};
    Edit draw(const Theme& theme) override
    {
        return transfer_field(theme, "transfer", points, chosen,
                              {.counts = counts, .lo = 0, .hi = 284, .most_points = 4}, 300);
    }
    static glm::vec2 at(double value, double opacity)
    {
        return {28 + value, 114 - 86 * std::sqrt(opacity)};
    }
    void click(glm::vec2 where, Button button = Button::left)
    {
        screen.input().push(move_to(where));
        screen.frames(2, body());
        screen.input().push(press(button));
        screen.input().push(press(button, false));
        screen.frames(5, body());
    }
};

TEST(TransferField, APointIsDraggedInValueAndOpacityBetweenItsNeighbours)
{
    TransferRig rig;
    rig.drag(TransferRig::at(100, 0.25), TransferRig::at(130, 0.64));
    EXPECT_EQ(rig.chosen, 1);
    EXPECT_NEAR(rig.points[1].value, 130, 1);
    EXPECT_NEAR(rig.points[1].opacity, 0.64, 0.03);
    EXPECT_GT(rig.changes, 1);
    rig.drag(rig.at(rig.points[1].value, rig.points[1].opacity), TransferRig::at(270, 0));
    EXPECT_EQ(rig.points[1].value, 200) << "not beyond the next one";
    EXPECT_NEAR(rig.points[1].opacity, 0, 0.001);
    EXPECT_EQ(rig.points[1].color, glm::vec3(1, 0, 0));
}

TEST(TransferField, ADoubleClickAddsAPointOfTheColourThereAndARightClickRemovesOne)
{
    TransferRig rig;
    rig.click(TransferRig::at(150, 0.64));
    EXPECT_EQ(rig.points.size(), 3u);
    rig.click(TransferRig::at(150, 0.64));
    ASSERT_EQ(rig.points.size(), 4u);
    EXPECT_EQ(rig.chosen, 2);
    EXPECT_NEAR(rig.points[2].value, 150, 1);
    EXPECT_NEAR(rig.points[2].color.r, 0.5, 0.02);
    EXPECT_NEAR(rig.points[2].color.b, 0.5, 0.02);
    EXPECT_EQ(rig.changes, 1);
    rig.click(TransferRig::at(150, 0.64), Button::right);
    EXPECT_EQ(rig.points.size(), 3u);
    EXPECT_EQ(rig.chosen, -1);
    EXPECT_EQ(rig.changes, 2);
}

TEST(TransferField, DeleteRemovesTheChosenPointAndTwoStay)
{
    TransferRig rig;
    for (int i = 0; i < 2; ++i) {
        rig.click(TransferRig::at(rig.points[1].value, 0.25));
        EXPECT_EQ(rig.chosen, 1);
        rig.screen.input().push(press_key(key_delete));
        rig.screen.input().push(press_key(key_delete, false));
        rig.screen.frames(4, rig.body());
    }
    EXPECT_EQ(rig.points.size(), 2u);
    EXPECT_EQ(rig.changes, 1);
}

TEST(TransferField, EscapeEndsTheDrag)
{
    TransferRig rig;
    rig.drag(TransferRig::at(100, 0.25), TransferRig::at(120, 0.5), false);
    rig.screen.input().push(press_key(key_escape));
    rig.screen.frames(3, rig.body());
    EXPECT_EQ(rig.cancels, 1);
}

} // namespace
} // namespace trivar::ui

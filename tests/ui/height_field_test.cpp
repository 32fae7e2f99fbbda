// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/height_field.h"

#include "tests/ui/field_rig.h"
#include "ui/keys.h"

#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

// A surface 300 wide at (20, 20), of 4 values along by 3 across: its cells are 66.5 x 24 from
// (54, 168), its picture 280 x 124 from (30, 30).
struct HeightRig : testing::FieldRig {
    HeightRig() : FieldRig({360, 320}) {}
    std::vector<std::vector<double>> values{{1, 1, 1}, {1, 1, 1}, {1, 2, 1}, {1, 1, 1}};
    Edit draw(const Theme& theme) override
    {
        const auto flat = [](double, double) { return 1.0; };
        return height_field(
            theme, "surface", values, chosen,
            {.at = flat, .along = {0, 0.25, 0.75, 1}, .across = {0, 0.5, 1}, .lo = 0.1, .hi = 5},
            300);
    }
    static glm::vec2 cell(int i, int j) { return {54 + 66.5 * (i + 0.5), 168 + 24 * (2.5 - j)}; }
};

TEST(HeightField, ACellIsDraggedUpAndDownAndNoOtherMoves)
{
    HeightRig rig;
    const auto before = rig.values;
    rig.drag(HeightRig::cell(1, 2), HeightRig::cell(1, 2) - glm::vec2(0, 40));
    EXPECT_EQ(rig.chosen, 1 * 3 + 2);
    EXPECT_NEAR(rig.values[1][2], 1 + 40 * 2.2 / 82, 0.06);
    EXPECT_GT(rig.changes, 1);
    rig.values[1][2] = 1;
    EXPECT_EQ(rig.values, before);
    rig.drag(HeightRig::cell(2, 1), HeightRig::cell(2, 1) + glm::vec2(0, 900));
    EXPECT_EQ(rig.values[2][1], 0.1); // within its range
}

TEST(HeightField, APointOfTheSurfaceIsDraggedToo)
{
    HeightRig rig;
    // The surface is drawn at 1 of 2.2, sheared by v.
    const glm::vec2 at{30 + 280 * (0.25 * 0.76 + 0.5 * 0.24),
                       154 - 124 * (0.5 * 0.34 + 1 / 2.2 * 0.66)};
    rig.drag(at, at - glm::vec2(0, 20));
    EXPECT_EQ(rig.chosen, 1 * 3 + 1);
    EXPECT_NEAR(rig.values[1][1], 1 + 20 * 2.2 / 82, 0.05);
}

TEST(HeightField, EscapeEndsTheDrag)
{
    HeightRig rig;
    rig.drag(HeightRig::cell(0, 0), HeightRig::cell(0, 0) - glm::vec2(0, 20), false);
    rig.screen.input().push(press_key(key_escape));
    rig.screen.frames(3, rig.body());
    EXPECT_EQ(rig.cancels, 1);
}

} // namespace
} // namespace trivar::ui

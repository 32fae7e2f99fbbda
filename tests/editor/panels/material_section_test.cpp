// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/rig.h"

namespace trivar {
namespace {

const std::vector<std::string> opacity{"material.base_color.w"};

TEST(MaterialSection, OpacityIsARowOfItsOwnThatChangesNothingElse)
{
    testing::Rig rig({1100, 900});
    rig.two_objects();
    SetMaterial red{{2}, {}};
    red.surfacing.base_color = {0.6f, 0.1f, 0.05f, 1};
    red.surfacing.roughness = 0.3f;
    ASSERT_TRUE(rig.editor.session.run(red));
    rig.wait();
    const ui::Rect in = rig.layout().inspector;
    std::optional<float> row;
    for (int page = 0; page < 8 && !row; ++page) {
        for (float y = in.lo.y + 8; y < in.hi.y && !row; y += 8) {
            rig.move({in.hi.x - 20, y});
            if (rig.editor.keys_under_mouse.names == opacity) row = y + 4;
        }
        if (row) break;
        rig.screen.input().push(ui::turn_wheel(-4));
        rig.frames(4);
    }
    ASSERT_TRUE(row) << "there is no such row";
    const std::size_t steps = rig.steps();
    rig.move({in.hi.x - 60, *row});
    rig.draw({{in.hi.x - 60, *row}, {in.hi.x - 100, *row}});
    rig.wait();
    ASSERT_EQ(rig.steps(), steps + 1);
    const Surfacing now = *object(rig.editor.session.committed(), 2).surfacing;
    EXPECT_LT(now.base_color.a, 0.95f);
    EXPECT_GE(now.base_color.a, 0);
    EXPECT_EQ(glm::vec3(now.base_color), glm::vec3(red.surfacing.base_color));
    EXPECT_EQ(now.roughness, red.surfacing.roughness);
}

} // namespace
} // namespace trivar

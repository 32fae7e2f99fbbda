// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/shown_volume.h"
#include "editor/panels/inspector/level_scouts.h"
#include "editor/session/volume_levels.h"
#include "tests/editor/panels/number_rows.h"
#include "tests/editor/volume_rig.h"

namespace trivar {
namespace {

// The inspector of a ball with two levels; its histogram lies below the card of the object.
struct VolumeSection : testing::VolumeRig {
    VolumeSection() : VolumeRig({1100, 1300})
    {
        add_ball({30, 60});
        editor.choose_tool(0);
    }
    // Where a value of the histogram stands.
    glm::vec2 on_histogram(double value)
    {
        const ui::Rect panel = layout().inspector;
        const float pad = screen.theme().size.padding + screen.theme().px(8);
        const auto& shown = *editor.session.evaluated().objects.at(1)->shape->volume;
        const double share = value / shown.summary->greatest; // the least is 0
        return {panel.lo.x + pad + static_cast<float>(share) * (panel.width() - 2 * pad),
                panel.lo.y + screen.theme().px(120)};
    }
};

TEST(VolumeSection, ADragOnTheHistogramIsOneStep)
{
    VolumeSection rig;
    rig.draw({rig.on_histogram(60), rig.on_histogram(80)});
    rig.wait();
    ASSERT_EQ(rig.steps(), 2u);
    EXPECT_NEAR(rig.shape().levels[1].value, 80, 2);
    EXPECT_EQ(rig.shape().levels[0].value, 30);
    EXPECT_EQ(rig.editor.session.level, (ChosenLevel{1, 1}));
}

TEST(VolumeSection, EscapeTakesTheDragBack)
{
    VolumeSection rig;
    rig.draw({rig.on_histogram(60), rig.on_histogram(80)}, false);
    EXPECT_TRUE(rig.editor.session.proposing());
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), 1u);
    EXPECT_FALSE(rig.editor.session.proposing());
}

TEST(VolumeSection, ADraggedLevelHaltsWhereTheLengthOfItsLinesHardlyChanges)
{
    VolumeSection rig;
    LevelScouts& scouts = rig.editor.memory.of<LevelScouts>();
    const ShownVolume& shown = *rig.editor.session.evaluated().objects.at(1)->shape->volume;
    const ScoutedVolume* scouted = scouts.of(rig.editor.session, shown);
    ASSERT_TRUE(scouted) << "it was found beside the window";
    EXPECT_EQ(scouted->curve.size(), 64u);
    ASSERT_FALSE(scouted->plateaus.empty());
    const double plateau = scouted->plateaus.front();
    const glm::vec2 off(4, 0);
    rig.draw({rig.on_histogram(30), rig.on_histogram(plateau) + off});
    rig.wait();
    EXPECT_EQ(rig.shape().levels[0].value, readable_value(plateau, *shown.summary));
    rig.hold(ui::key_left_control);
    rig.draw({rig.on_histogram(plateau), rig.on_histogram(plateau) + off});
    rig.hold(ui::key_left_control, false);
    rig.wait();
    EXPECT_GT(rig.shape().levels[0].value, plateau + 0.5);
    EXPECT_EQ(rig.steps(), 3u);
}

TEST(VolumeSection, LevelsAndTheirLinesTakeTypedNumbersAndKeys)
{
    VolumeSection rig;
    for (const char* number : {"shape.levels.0.value", "shape.levels.0.ink.width"}) {
        rig.click(testing::number_field(rig, number));
        rig.frames(4);
        rig.type("7");
        rig.key({ui::key_enter});
        rig.wait();
    }
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_EQ(rig.shape().levels[0].value, 7);
    EXPECT_EQ(rig.shape().levels[0].ink.width, 7);
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/stages/shown_volume.h"
#include "editor/panels/inspector/transfer_rows.h"
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
    LevelScouts& scouts = rig.editor.session.level_scouts;
    const ShownVolume& shown = *rig.editor.session.evaluated().objects.at(1)->shape->volume;
    const ScoutedVolume* scouted = scouts.of(rig.editor.session.quiet_jobs(), shown);
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

TEST(VolumeSection, KeepsTheHistogramOfHiddenData)
{
    VolumeSection rig;
    rig.frames(2);
    const glm::vec2 from = rig.on_histogram(60), to = rig.on_histogram(80);
    ASSERT_TRUE(rig.editor.session.run(Hide{{1}}));
    rig.wait();
    ASSERT_FALSE(rig.editor.session.evaluated().objects.contains(1));
    rig.hold(ui::key_left_control); // halts nowhere
    rig.draw({from, to});
    rig.hold(ui::key_left_control, false);
    rig.wait();
    ASSERT_EQ(rig.steps(), 3u);
    EXPECT_NEAR(rig.shape().levels[1].value, 80, 2);
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

// The ball seen as a whole, without levels.
struct CastingSection : testing::VolumeRig {
    CastingSection() : VolumeRig({1100, 1300})
    {
        AddVoxels add;
        add.shape.path = folder.file("ball.nrrd");
        EXPECT_TRUE(editor.session.run(prepare(add, *editor.session.assets())));
        SetVoxels set{1, shape()};
        set.shape.levels.clear();
        set.shape.casting.shown = true;
        EXPECT_TRUE(editor.session.run(set));
        editor.session.selected = 1;
        editor.choose_tool(0);
        wait();
        before = steps();
    }
    std::size_t before = 0;
    const std::vector<TransferPoint>& points() const { return shape().casting.points; }
    // Drags the point that begins what is dense, by some pixels. It is looked for above the row
    // below the function.
    void drag_a_point(bool let_go = true)
    {
        const auto& shown = *editor.session.evaluated().objects.at(1)->shape->volume;
        const double value = usual_transfer(*shown.summary, shown.field->grid())[4].value;
        glm::vec2 at = testing::number_field(*this, "shape.casting.density");
        const float bottom = at.y - 20;
        const ui::Rect panel = layout().inspector;
        const float pad = screen.theme().size.padding + screen.theme().px(8);
        const double share = value / shown.summary->greatest; // the least is 0
        at.x = panel.lo.x + pad + static_cast<float>(share) * (panel.width() - 2 * pad);
        for (at.y = bottom - 180; at.y < bottom; at.y += 12) {
            draw({at, at + glm::vec2(9, 14)}, let_go);
            if (!let_go && editor.session.proposing()) return;
            if (!let_go) screen.input().push(ui::press(ui::Button::left, false));
            wait();
            if (!points().empty()) return;
        }
        FAIL() << "no point is dragged";
    }
};

TEST(CastingSection, ADragOfAPointIsOneStepAndUndone)
{
    CastingSection rig;
    rig.drag_a_point();
    EXPECT_EQ(rig.steps(), rig.before + 1);
    EXPECT_EQ(rig.points().size(), 6u) << "those of the histogram became its own";
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.points().empty());
}

TEST(CastingSection, EscapeTakesTheDragBack)
{
    CastingSection rig;
    rig.drag_a_point(false);
    EXPECT_TRUE(rig.editor.session.proposing());
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_FALSE(rig.editor.session.proposing());
    EXPECT_EQ(rig.steps(), rig.before);
}

TEST(CastingSection, TheChosenPointTakesTypedNumbers)
{
    CastingSection rig;
    rig.drag_a_point();
    const int chosen = rig.editor.memory.of<ChosenTransferPoint>().number;
    ASSERT_GE(chosen, 0);
    rig.click(
        testing::number_field(rig, "shape.casting.points." + std::to_string(chosen) + ".opacity"));
    rig.frames(4);
    rig.type("40");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(rig.points()[static_cast<std::size_t>(chosen)].opacity, 0.4, 1e-9);
    EXPECT_EQ(rig.steps(), rig.before + 2);
}

} // namespace
} // namespace trivar

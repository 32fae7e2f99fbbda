// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/silhouettes.h"
#include "editor/hands/level_under.h"
#include "editor/session/session_facts.h"
#include "editor/session/volume_levels.h"
#include "tests/editor/volume_rig.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// A ball with two levels, and the tool that works on them.
struct Levels : testing::VolumeRig {
    Levels()
    {
        add_ball({30.5, 60.5});
        editor.choose_tool("Silhouettes");
        move(middle());
    }
    glm::vec2 middle() const { return layout().view.center(); }
    void let_go()
    {
        screen.input().push(ui::press(ui::Button::left, false));
        frames(2);
        wait();
    }
};

TEST(Silhouettes, ADragMovesTheChosenLevelInOneStep)
{
    Levels rig;
    rig.editor.session.level = {1, 1};
    rig.draw({rig.middle(), rig.middle() - glm::vec2(0, 60)}, false);
    EXPECT_TRUE(rig.editor.active_tool().busy());
    EXPECT_TRUE(rig.editor.session.proposing());
    rig.let_go();
    ASSERT_EQ(rig.steps(), 2u);
    EXPECT_GT(rig.shape().levels[1].value, 62);
    EXPECT_EQ(rig.shape().levels[0].value, 30.5);
}

TEST(Silhouettes, EscapeTakesTheDragBack)
{
    Levels rig;
    rig.draw({rig.middle(), rig.middle() - glm::vec2(0, 60)}, false);
    rig.key({ui::key_escape});
    rig.let_go();
    EXPECT_EQ(rig.steps(), 1u);
    EXPECT_FALSE(rig.editor.session.proposing());
}

TEST(Silhouettes, ADragHaltsWhereTheLengthOfTheLinesHardlyChanges)
{
    Levels rig;
    rig.wait();
    Session& session = rig.editor.session;
    const ShownVolume& shown = *session.evaluated().objects.at(1)->shape->volume;
    const ScoutedVolume* scouted = session.level_scouts.of(session.quiet_jobs(), shown);
    ASSERT_TRUE(scouted) << "it was found beside the window";
    ASSERT_FALSE(scouted->plateaus.empty());
    const double plateau = scouted->plateaus.back();
    const double range = shown.summary->greatest - shown.summary->least;
    session.level = {1, 1};
    // 3 pixels beyond it.
    const auto up = static_cast<float>((plateau - 60.5) / range * 600 + 3);
    const glm::vec2 to = rig.middle() - glm::vec2(0, up);
    rig.draw({rig.middle(), to});
    rig.wait();
    EXPECT_EQ(rig.shape().levels[1].value, readable_value(plateau, *shown.summary));
    session.undo();
    rig.wait();
    rig.hold(ui::key_left_control);
    rig.draw({rig.middle(), to});
    rig.hold(ui::key_left_control, false);
    rig.wait();
    EXPECT_NEAR(rig.shape().levels[1].value, plateau + 3 * range / 600, 0.3);
    EXPECT_NE(rig.shape().levels[1].value, readable_value(plateau, *shown.summary));
}

TEST(Silhouettes, AClickOnALineChoosesItsLevel)
{
    Levels rig;
    const Box box = bounds_of(rig.editor.session, 1);
    const Camera& camera = rig.editor.session.view.camera;
    for (const int level : {1, 0}) {
        // To the right of the middle, until there is a line of that level.
        glm::dvec2 at = project(camera, box.center()).p_px;
        while (at.x < camera.size_px.x && level_under(rig.editor.session, 1, at, 2) != level)
            ++at.x;
        ASSERT_LT(at.x, camera.size_px.x);
        rig.click(rig.layout().view.lo + glm::vec2(at));
        EXPECT_EQ(rig.editor.session.level, (ChosenLevel{1, level}));
    }
    EXPECT_EQ(rig.steps(), 1u) << "a click changes nothing";
}

TEST(Silhouettes, DigitsChooseALevel)
{
    Levels rig;
    rig.key({'2'});
    EXPECT_EQ(rig.editor.session.level, (ChosenLevel{1, 1}));
    rig.key({'9'});
    EXPECT_EQ(rig.editor.session.level, (ChosenLevel{1, 1})) << "there is none";
    rig.key({'1'});
    EXPECT_EQ(rig.editor.session.level, (ChosenLevel{1, 0}));
}

TEST(Silhouettes, TheWheelWithCtrlMovesTheLevelInOneStep)
{
    Levels rig;
    const glm::dvec3 eye = rig.editor.session.view.camera.eye;
    rig.hold(ui::key_left_control);
    for (int i = 0; i < 3; ++i) {
        rig.screen.input().push(ui::turn_wheel(1));
        rig.frames(2);
    }
    rig.hold(ui::key_left_control, false);
    rig.wait();
    ASSERT_EQ(rig.steps(), 2u);
    EXPECT_GT(rig.shape().levels[0].value, 31);
    EXPECT_EQ(rig.editor.session.view.camera.eye, eye) << "it does not zoom";
}

TEST(Silhouettes, NewLevelsHaveColoursOfTheirOwn)
{
    VoxelShape shape;
    VolumeSummary summary;
    summary.greatest = 100;
    for (int i = 0; i < 4; ++i)
        shape.levels.push_back(new_level(shape, next_value(shape, summary)));
    for (std::size_t i = 0; i < shape.levels.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NE(shape.levels[i].ink.color, shape.levels[k].ink.color);
            EXPECT_NE(shape.levels[i].value, shape.levels[k].value);
        }
}

} // namespace
} // namespace trivar

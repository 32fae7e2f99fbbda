// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/view.h"
#include "editor/tools/split/split.h"

#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "editor/tools/split/split_handles.h"
#include "tests/editor/rig.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

constexpr Id split_ball = 1, split_pillar = 2;

// A ball, which is selected, and a pillar that stands out of it to the right of its middle.
struct SplitRig : testing::Rig {
    SplitRig()
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 1}}));
        Transform beside;
        beside.translation = {0.1, 0.3, 0};
        EXPECT_TRUE(editor.session.run(
            AddCylinder{.shape = {.radius = 0.2, .height = 5}, .transform = beside}));
        editor.session.selected = split_ball;
        editor.session.view.camera.eye = {0, -7, 1};
        editor.session.view.camera.target = {0, 0, 0};
        key({'K'});
        wait();
    }
    // Where the pillar is seen above the ball.
    glm::vec2 on_the_pillar()
    {
        const PicturePoint at = project(editor.session.view.camera, {0.1, 0.3, 1.8});
        return layout().view.lo + glm::vec2(at.p_px);
    }
    bool parted() const
    {
        return editor.session.evaluated().objects.at(split_ball)->split_field != nullptr;
    }
};

TEST(SplitTool, ShowsWhatAnObstacleWouldDoAndDoesItByAClick)
{
    SplitRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Split");
    const std::size_t before = rig.steps();
    rig.move(rig.on_the_pillar());
    rig.wait();
    rig.move(rig.on_the_pillar() + glm::vec2(1, 0));
    rig.wait();
    EXPECT_TRUE(rig.parted());
    EXPECT_EQ(rig.steps(), before); // it is only shown
    EXPECT_FALSE(object(rig.editor.session.committed(), split_ball).splitting);
    EXPECT_FALSE(
        rig.editor.active_tool().helpers(rig.editor.session, rig.screen.theme()).lines.empty());
    rig.move(rig.layout().view.lo + glm::vec2(5, 5));
    rig.wait();
    EXPECT_FALSE(rig.parted());
    rig.click(rig.on_the_pillar());
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(object(rig.editor.session.committed(), split_ball).splitting);
    EXPECT_EQ(object(rig.editor.session.committed(), split_ball).splitting->obstacles.at(0).object,
              split_pillar);
    EXPECT_TRUE(rig.parted());
    rig.editor.session.undo();
    rig.wait();
    EXPECT_FALSE(rig.parted());
}

TEST(SplitTool, ShowsOneThingToAMouseThatRests)
{
    testing::Rig rig;
    rig.draw_whole(); // the mouse is at the rim of what it picks
    ASSERT_TRUE(rig.editor.session.run(
        AddTorus{.shape = {.radius = 0.8, .tube = 0.3, .segments = {24, 12}}}));
    Transform in_the_ring;
    in_the_ring.translation = {0.8, 0, 0};
    ASSERT_TRUE(rig.editor.session.run(
        AddCylinder{.shape = {.radius = 0.15, .height = 3}, .transform = in_the_ring}));
    rig.editor.session.selected = 1;
    rig.editor.session.view.camera.eye = {2.5, -4, 2.5};
    rig.editor.session.view.camera.target = {0.4, 0, 0};
    rig.key({'K'});
    rig.wait();
    const glm::vec2 post = rig.seen_at({0.8, 0, 0});
    for (int x = -20; x <= 20; x += 4)
        for (int y = -60; y <= 60; y += 12) {
            rig.move(post + glm::vec2(x, y));
            for (int i = 0; i < 3; ++i) rig.wait();
            const long change = rig.editor.session.change();
            for (int i = 0; i < 3; ++i) rig.wait();
            EXPECT_EQ(rig.editor.session.change(), change) << x << " " << y;
        }
}

TEST(SplitTool, ShowsTheSameWhereAHandleOfWhatItShowsComesUnderTheMouse)
{
    SplitRig rig;
    rig.draw_whole(); // the mouse is at the rim of what it picks
    Transform before; // the middle of the opening is seen on the pillar
    before.translation = {0.1, -0.9, 0};
    ASSERT_TRUE(rig.editor.session.run(SetTransform{split_pillar, before}));
    rig.move(rig.on_the_pillar());
    rig.wait();
    ASSERT_TRUE(rig.parted());
    std::vector<glm::vec2> handles;
    const Session& session = rig.editor.session;
    for (const Handle& each : opening_handles(session, 1))
        if (each.key.kind == "place") // the others stand beside the pillar
            handles.push_back(rig.seen_at(each.p_world));
    ASSERT_FALSE(handles.empty());
    for (const glm::vec2 at : handles) {
        rig.move(rig.layout().view.lo + glm::vec2(5, 5));
        rig.wait();
        rig.move(at);
        for (int i = 0; i < 3; ++i) rig.wait();
        EXPECT_TRUE(rig.parted());
        const long change = session.change();
        for (int i = 0; i < 3; ++i) rig.wait();
        EXPECT_EQ(session.change(), change);
    }
    const std::size_t steps = rig.steps();
    rig.click(handles.front()); // does what it shows
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_TRUE(object(session.committed(), split_ball).splitting);
}

TEST(SplitTool, OpensAcrossTheWayOnWhichTheObjectPasses)
{
    SplitRig rig;
    const auto opening = [&] {
        const std::optional<Split> command =
            split_at(rig.editor.session, {split_ball}, split_pillar);
        return command ? command->splitting.opening : glm::dvec3(0);
    };
    EXPECT_NEAR(std::abs(opening().x), 0.95, 0.06); // toward the pillar
    EXPECT_EQ(opening().z, 0);
    Animate along_x;
    Track track;
    track.parameter = "transform.translation.x";
    track.keys = {{1, -3}, {24, 3}};
    along_x.of = {{split_ball, {track}}};
    ASSERT_TRUE(rig.editor.session.run(along_x));
    ASSERT_TRUE(rig.editor.session.run(SetTime{{.first_frame = 1, .last_frame = 24}}));
    rig.wait();
    EXPECT_EQ(opening(), glm::dvec3(0, -1, 0));
}

TEST(SplitTool, ForgetsAnObstacleThatIsDeletedUnderTheMouse)
{
    SplitRig rig;
    rig.move(rig.on_the_pillar());
    rig.wait();
    ASSERT_TRUE(rig.editor.session.run(Delete{{split_pillar}}));
    rig.move(rig.on_the_pillar() + glm::vec2(1, 0)); // over its last picture
    rig.wait();
    EXPECT_FALSE(rig.parted());
    EXPECT_FALSE(rig.editor.session.document().objects.contains(split_pillar));
}

} // namespace
} // namespace trivar

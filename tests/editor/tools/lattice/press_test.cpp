// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/placement.h"
#include "tests/editor/rig.h"
#include "tests/ffd/folds.h"

namespace trivar {
namespace {

using testing::Rig;

// The box laid on the plane, and the ball in the hand.
struct PressRig : Rig {
    PressRig()
    {
        two_objects();
        key({'D'});
        draw(stroke());
        wait();
        editor.session.view.camera.eye = {0.5, -5, 2};
        key({'P'});
        wait();
    }
    const Placement& laid() const { return *editor.session.evaluated().objects.at(2)->placement; }
    glm::dvec3 roof() const { return evaluate(laid().volume, {0.5, 0.5, 1}).value; }
    const Press& last() const
    {
        return *object(editor.session.document(), 2).shaping.back()->press;
    }
    void drag(glm::vec2 by, bool let_go = true)
    {
        const glm::vec2 at = seen_at(roof());
        move(at);
        draw({at, at + by}, let_go);
        wait();
    }
};

TEST(PressTool, PressesAsDeepAsItIsDraggedInOneStep)
{
    PressRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Press");
    const std::size_t before = rig.steps();
    const glm::dvec3 roof = rig.roof();
    rig.drag({0, 12});
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(object(rig.editor.session.document(), 2).shaping.size(), 1u);
    EXPECT_NEAR(rig.last().samples.front().x, 0.5, 0.1);
    EXPECT_GT(rig.last().samples.front().w, 0);
    EXPECT_LT(rig.roof().z, roof.z - 0.01);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.roof(), roof);
    rig.drag({0, -12});
    EXPECT_GT(rig.roof().z, roof.z + 0.01);
}

TEST(PressTool, StopsBeforeTheVolumeFoldsAndSaysSo)
{
    PressRig rig;
    rig.drag({0, 300});
    EXPECT_EQ(testing::verdict_of(rig.laid().volume), Verdict::proven_good);
    const auto& notices = rig.editor.session.notices.all();
    ASSERT_FALSE(notices.empty());
    EXPECT_EQ(notices.back().title, "The volume would fold here");
}

TEST(PressTool, IsCancelledWithoutATrace)
{
    PressRig rig;
    const std::size_t before = rig.steps();
    const glm::dvec3 roof = rig.roof();
    rig.drag({0, 20}, false);
    EXPECT_NE(rig.roof(), roof);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.roof(), roof);
    EXPECT_TRUE(object(rig.editor.session.document(), 2).shaping.empty());
}

TEST(PressTool, TakesADepthThatIsTypedAndARadiusByKeys)
{
    PressRig rig;
    rig.drag({0, 6}, false);
    const double radius = rig.last().radius;
    rig.type("-0.03");
    rig.wait();
    EXPECT_DOUBLE_EQ(rig.last().samples.front().w, -0.03);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    rig.key({']'});
    rig.drag({0, 6});
    EXPECT_NEAR(rig.last().radius, 1.1 * radius, 0.01 * radius);
    rig.key({'['});
    rig.drag({0, 6});
    EXPECT_NEAR(rig.last().radius, radius, 0.02 * radius);
}

TEST(PressTool, BesideTheVolumeSelects)
{
    PressRig rig;
    rig.click(rig.layout().view.lo + glm::vec2(20, 300));
    EXPECT_EQ(rig.steps(), 3u + 0u);
    EXPECT_TRUE(object(rig.editor.session.document(), 2).shaping.empty());
}

} // namespace
} // namespace trivar

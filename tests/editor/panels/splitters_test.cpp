// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

void drag(Rig& rig, glm::vec2 from, glm::vec2 to)
{
    rig.move(from);
    rig.screen.input().push(ui::press(ui::Button::left));
    rig.frames(2);
    rig.move((from + to) / 2.0f);
    rig.move(to);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames(2);
}

TEST(Splitters, GiveThePanelsTheSizesTheyAreDraggedTo)
{
    Rig rig;
    rig.frames();
    const Layout before = rig.layout();
    const glm::vec2 dock{before.outliner.lo.x - 1, 400};
    drag(rig, dock, dock - glm::vec2(60, 0));
    EXPECT_NEAR(rig.editor.preferences.dock, 720 - dock.x + 60, 2);
    const glm::vec2 below{600, before.outliner.hi.y};
    drag(rig, below, below - glm::vec2(0, 40));
    EXPECT_NEAR(rig.layout().outliner.hi.y, before.outliner.hi.y - 40, 2);
}

TEST(Splitters, LetTheTimelineGrowAsFarAsThePictureKeepsRoom)
{
    Rig rig({1024, 800});
    rig.editor.preferences.timeline_open = true;
    rig.frames();
    const Layout before = rig.layout();
    drag(rig, {400, before.timeline.lo.y - 1}, {400, before.timeline.lo.y - 101});
    EXPECT_NEAR(rig.layout().timeline.height(), before.timeline.height() + 100, 2);
    drag(rig, {400, rig.layout().timeline.lo.y - 1}, {400, 5});
    const Layout highest = rig.layout();
    EXPECT_GT(highest.timeline.height(), 400);
    EXPECT_GE(highest.view.height(), 199) << "a hand can still work in it";
    drag(rig, {400, highest.timeline.lo.y - 1}, {400, highest.timeline.lo.y + 59});
    EXPECT_NEAR(rig.layout().timeline.height(), highest.timeline.height() - 60, 2)
        << "it follows at once: no more than there was room for is remembered";
    const Layout low =
        layout_of(rig.screen.theme(), {1024, 420}, rig.editor.preferences, rig.editor.tools.size());
    EXPECT_GE(low.view.height(), 100);
}

TEST(Splitters, HideTheDockAtTheEdgeAndBringItBack)
{
    Rig rig;
    rig.frames();
    const glm::vec2 dock{rig.layout().outliner.lo.x - 1, 400};
    drag(rig, dock, {715, 400});
    EXPECT_FALSE(rig.editor.preferences.show_dock);
    drag(rig, {719, 400}, {400, 400});
    EXPECT_TRUE(rig.editor.preferences.show_dock);
}

TEST(Splitters, FollowTheHandBetweenTwoClicksWhereThatIsPreferred)
{
    Rig rig;
    rig.editor.preferences.look.click_holds = true;
    rig.frames();
    const glm::vec2 dock{rig.layout().outliner.lo.x - 1, 400};
    rig.move(dock);
    rig.click(dock);
    rig.move(dock - glm::vec2(60, 0));
    rig.click(dock - glm::vec2(60, 0));
    rig.move(dock);
    EXPECT_NEAR(rig.editor.preferences.dock, 720 - dock.x + 60, 2);
}

} // namespace
} // namespace trivar

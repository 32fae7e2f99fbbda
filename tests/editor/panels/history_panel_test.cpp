// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

struct Steps : Rig {
    Steps()
    {
        two_objects();
        editor.session.run(Hide{{2}});
        editor.tab = Editor::Tab::history;
        wait();
    }
    glm::vec2 line(int i) const { return layout().inspector.lo + glm::vec2(80, 28 * i + 14); }
    bool seen(Id id) const { return editor.session.evaluated().objects.contains(id); }
};

TEST(HistoryPanel, AMouseThatRestsOnAStepShowsItAndChangesNothing)
{
    Steps rig;
    ASSERT_FALSE(rig.seen(2));
    rig.move(rig.line(2));
    rig.frames(25);
    rig.wait();
    EXPECT_TRUE(rig.editor.session.previewing());
    EXPECT_TRUE(rig.seen(2));
    EXPECT_EQ(rig.steps(), 3u);
    EXPECT_TRUE(object(rig.editor.session.document(), 2).hidden);
    rig.move(rig.layout().view.center());
    rig.wait();
    EXPECT_FALSE(rig.editor.session.previewing());
    EXPECT_FALSE(rig.seen(2));
}

TEST(HistoryPanel, OtherStepsAreKeptAndCanBeReturnedTo)
{
    Steps rig;
    rig.editor.session.go_to_step(1);
    rig.editor.session.run(AddSphere{});
    rig.wait();
    const History& history = rig.editor.session.scene().history();
    ASSERT_EQ(history.branches().size(), 1u);
    rig.click(rig.line(2)); // "Other steps (2)", below the plane
    rig.click(rig.line(3)); // the box
    rig.wait();
    EXPECT_EQ(object(rig.editor.session.document(), 2).name, "Box");
    EXPECT_EQ(rig.steps(), 2u);
    EXPECT_EQ(history.steps().size(), 3u) << "hiding it can be brought back";
    ASSERT_EQ(history.branches().size(), 1u);
    EXPECT_EQ(verb(history.branches()[0].steps[0].command), "add_sphere");
}

TEST(HistoryPanel, ShowsNothingElseWhileTheMouseRestsWhereItClicked)
{
    Steps rig;
    rig.editor.session.go_to_step(1);
    rig.editor.session.run(AddSphere{});
    rig.wait();
    rig.click(rig.line(2)); // "Other steps (2)"
    rig.click(rig.line(3)); // the box; the rows change places
    rig.frames(40);
    rig.wait();
    EXPECT_FALSE(rig.editor.session.previewing());
    rig.move(rig.line(0));
    rig.frames(25);
    EXPECT_TRUE(rig.editor.session.previewing());
}

} // namespace
} // namespace trivar

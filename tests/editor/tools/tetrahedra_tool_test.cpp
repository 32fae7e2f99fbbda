// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/primitives.h"
#include "editor/tools/lattice_round.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

// A ball in tetrahedra (object 2), and the tool that pulls them.
struct TetrahedraRig : Rig {
    TetrahedraRig()
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 0.5}}));
        wait();
        editor.session.selected = 1;
        action(editor, tetrahedra_action).run(editor);
        editor.session.view.camera.eye = {0, -4, 0.5};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
    }
    const TetrahedraShape& shape() const
    {
        return std::get<TetrahedraShape>(object(editor.session.document(), 2).source);
    }
    void drag(glm::vec2 by, bool let_go = true)
    {
        const glm::vec2 at = seen_at({0.1, -0.48, 0.1});
        move(at);
        draw({at, at + 0.5f * by, at + by}, let_go);
        wait();
    }
};

TEST(TetrahedraTool, PutsTetrahedraRoundWhatIsSelectedAndIsChosen)
{
    TetrahedraRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Tetrahedra");
    EXPECT_EQ(rig.editor.session.selected, 2);
    EXPECT_EQ(object(rig.editor.session.document(), 1).parent, 2);
    EXPECT_GE(rig.shape().size.x, 1.0);
}

TEST(TetrahedraTool, PullsWhatTheBallHoldsInOneStep)
{
    TetrahedraRig rig;
    const std::size_t before = rig.steps();
    rig.drag({30, 0});
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.shape().edits.size(), 1U);
    const TetrahedraPull& pull = *rig.shape().edits[0].pull;
    EXPECT_NEAR(pull.at.y, -0.48, 0.05); // where the mouse was on the ball
    EXPECT_GT(pull.by.x, 0.01);
    EXPECT_NEAR(pull.by.y, 0, 1e-9); // in the plane that the camera faces
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.shape().edits.empty());
}

TEST(TetrahedraTool, IsCancelledWithoutATrace)
{
    TetrahedraRig rig;
    const std::size_t before = rig.steps();
    rig.drag({30, 0}, false);
    EXPECT_EQ(rig.shape().edits.size(), 1U);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_TRUE(rig.shape().edits.empty());
}

TEST(TetrahedraTool, FitsTetrahedraToWhatTheyHold)
{
    Rig rig;
    ASSERT_TRUE(rig.editor.session.run(AddTorus{}));
    rig.wait();
    rig.editor.session.selected = 1;
    action(rig.editor, fitted_tetrahedra_action).run(rig.editor);
    rig.wait();
    const auto& shape = std::get<TetrahedraShape>(object(rig.editor.session.document(), 2).source);
    EXPECT_GE(shape.cells.size(), 200U);
    const auto& shown = *rig.editor.session.evaluated().objects.at(2);
    ASSERT_TRUE(shown.tetrahedra);
}

} // namespace
} // namespace trivar

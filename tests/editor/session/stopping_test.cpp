// SPDX-License-Identifier: GPL-3.0-or-later
// Long work on the scene that is stopped, and what can be done then.
#include "core/refinement/refine.h"
#include "editor/jobs/background_evaluator.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

namespace trivar {
namespace {

struct StoppedWork : ::testing::Test {
    testing::Rig rig;
    Session& session = rig.editor.session;
    // A scene whose last step takes seconds, stopped at that.
    StoppedWork()
    {
        session.replace_scene(testing::typical_scene());
        rig.wait();
        session.run(Refine{{2}, {.tolerance = 2e-5, .budget = 4'000'000}});
        while (session.evaluator().status().stage != "refining") std::this_thread::yield();
        session.evaluator().cancel();
        rig.wait();
    }
    const ui::Notices::Notice& notice() { return session.notices.all().back(); }
};

TEST_F(StoppedWork, LeavesThePictureAndOffersToTakeTheStepBack)
{
    EXPECT_FALSE(session.evaluated().objects.at(2)->refined);
    ASSERT_EQ(notice().title, "Stopped");
    ASSERT_EQ(notice().actions.size(), 2u);
    notice().actions[0].act();
    rig.wait();
    EXPECT_FALSE(object(session.document(), 2).refining);
    EXPECT_TRUE(session.up_to_date());
}

TEST_F(StoppedWork, GoesOnWhereThatIsWanted)
{
    notice().actions[1].act();
    rig.wait();
    ASSERT_TRUE(session.evaluated().objects.at(2)->refined);
    EXPECT_LE(session.evaluated().objects.at(2)->refined->bound, 2e-5);
}

} // namespace
} // namespace trivar

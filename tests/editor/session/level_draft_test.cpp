// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/shown_volume.h"
#include "editor/session/level_draft.h"
#include "tests/editor/volume_rig.h"

#include <gtest/gtest.h>
#include <thread>

namespace trivar {
namespace {

// A ball of 160^3 samples, of which a level is dragged.
struct LargeBall : ::testing::Test {
    testing::VolumeRig rig;
    Session& session = rig.editor.session;
    LargeBall()
    {
        testing::write_file(rig.folder.file("ball.nrrd"), write_nrrd(testing::ball_grid(160)));
        rig.add_ball({40.5});
    }
    glm::ivec3 size() const
    {
        return session.evaluated().objects.at(1)->shape->volume->field->grid().size;
    }
    bool propose(double value)
    {
        SetVoxels set{1, rig.shape()};
        set.shape.levels[0].value = value;
        return session.propose(set);
    }
    void wait_for_one_evaluation()
    {
        const long before = session.evaluation();
        while (session.evaluation() == before) {
            session.poll();
            std::this_thread::yield();
        }
    }
};

TEST_F(LargeBall, IsShownByFewerSamplesWhileALevelIsDragged)
{
    ASSERT_EQ(size(), glm::ivec3(160));
    ASSERT_TRUE(propose(45.5));
    wait_for_one_evaluation();
    EXPECT_EQ(size(), glm::ivec3(80));
    EXPECT_FALSE(session.up_to_date());
    const auto level = session.evaluated().objects.at(1)->shape->volume->levels.at(0);
    EXPECT_GT(level.mesh->triangle_count(), 1000u);
    rig.wait(); // the hand rests
    EXPECT_EQ(size(), glm::ivec3(160));
    ASSERT_TRUE(propose(46.5));
    session.commit();
    rig.wait();
    EXPECT_EQ(size(), glm::ivec3(160));
    EXPECT_EQ(rig.shape().levels[0].value, 46.5);
    EXPECT_EQ(rig.shape().coarsen, 1);
}

TEST_F(LargeBall, IsShownWholeWhileAnythingElseChanges)
{
    SetVoxels set{1, rig.shape()};
    set.shape.levels[0].value = 45.5;
    set.shape.blur = 1;
    ASSERT_TRUE(session.propose(set));
    wait_for_one_evaluation();
    EXPECT_EQ(size(), glm::ivec3(160));
}

TEST(LevelDraft, OfSmallDataIsNone)
{
    testing::VolumeRig rig;
    rig.add_ball({30.5});
    Document now = rig.editor.session.document();
    Object changed = object(now, 1);
    std::get<VoxelShape>(changed.source).levels[0].value = 35;
    now.objects.set(1, make_ref(std::move(changed)));
    EXPECT_FALSE(level_draft(rig.editor.session.document(), now, rig.editor.session.evaluated()));
}

} // namespace
} // namespace trivar

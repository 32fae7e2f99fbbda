// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/primitives.h"
#include "core/document/document_digest.h"
#include "core/scene/scene_file.h"
#include "tests/support/fixtures.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::TemporaryFolder;

// A scene with a box that another window works on.
struct LookedAt : ::testing::Test {
    LookedAt()
    {
        scene.save_as(path);
        scene.run(AddBox{});
        looked = SceneFile::looked_at(path);
    }
    TemporaryFolder folder;
    std::string path = folder.file("a.trivar");
    SceneFile scene, looked;
};

TEST_F(LookedAt, FollowsWhatTheOtherWindowDoes)
{
    EXPECT_FALSE(looked.follow());
    scene.run(AddSphere{});
    scene.run(AddTorus{});
    scene.undo();
    EXPECT_TRUE(looked.follow());
    EXPECT_EQ(digest(looked.document()), digest(scene.document()));
    EXPECT_EQ(looked.lines(), scene.lines());
    EXPECT_FALSE(looked.follow());
}

TEST_F(LookedAt, WaitsForTheEndOfALine)
{
    std::ofstream(path, std::ios::app) << "{\"do\":\"add_";
    EXPECT_FALSE(looked.follow());
    std::ofstream(path, std::ios::app) << "torus\"}\n";
    EXPECT_TRUE(looked.follow());
    EXPECT_EQ(looked.document().objects.size(), 2u);
}

TEST_F(LookedAt, ReadsAFileAnewThatWasReplaced)
{
    scene.run(AddSphere{});
    scene.undo();
    scene.save_compact(path);
    EXPECT_TRUE(looked.follow());
    EXPECT_EQ(looked.lines(), scene.lines());
    std::filesystem::remove(path);
    EXPECT_FALSE(looked.follow());
    EXPECT_EQ(looked.document().objects.size(), 1u);
}

TEST_F(LookedAt, RefusesEveryChangeTillItIsSavedUnderAnotherName)
{
    const std::size_t lines = looked.lines().size();
    EXPECT_THROW(looked.run(AddTorus{}), Rejected);
    EXPECT_THROW(looked.propose(AddTorus{}), Rejected);
    EXPECT_THROW(looked.undo(), Rejected);
    EXPECT_TRUE(looked.as_opened());
    EXPECT_EQ(looked.lines().size(), lines);
    EXPECT_THROW(looked.save_as(path), Rejected) << "the other window has it";
    looked.save_as(folder.file("b.trivar"));
    EXPECT_FALSE(looked.look_only());
    looked.run(AddTorus{});
    EXPECT_FALSE(looked.follow());
    EXPECT_EQ(scene.document().objects.size(), 1u);
}

} // namespace
} // namespace trivar

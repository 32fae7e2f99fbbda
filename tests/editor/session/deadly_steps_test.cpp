// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that ended the programs that worked on them.
#include "core/base/text.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/log.h"
#include "editor/session/recovery.h"
#include "tests/support/dying.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;

struct DeadlyScene : ::testing::Test {
    testing::TemporaryFolder kept, scenes;
    const std::string folder = kept.path().string(), path = scenes.file("a.trivar");
    Session session{[] {}, folder};
    Recovery recovery{session};

    static std::string three_steps()
    {
        return log_header() + command_line(AddBox{}) + command_line(AddSphere{}) +
               command_line(AddTorus{});
    }
    DeadlyScene() { testing::write_file(path, three_steps()); }
    void die_at(const std::string& file, bool at_work = true) const
    {
        testing::die_with([&] {
            const std::size_t lines = SceneFile::copy_of(file).lines().size();
            static LifeSign sign(folder, file, lines, at_work);
        });
    }
    std::size_t position() const { return session.scene().history().position(); }
    const ui::Notices::Notice* notice() const
    {
        for (const auto& each : session.notices.all())
            if (each.title.find("undone") != std::string::npos) return &each;
        return nullptr;
    }
};

TEST_F(DeadlyScene, OpensTheThirdTimeWithoutItsLastStepAndSaysSo)
{
    die_at(path);
    session.replace_scene(SceneFile(path));
    EXPECT_EQ(position(), 3u);
    session.replace_scene(SceneFile()); // left well
    die_at(path);
    die_at(path);
    session.replace_scene(SceneFile(path));
    EXPECT_EQ(position(), 2u);
    EXPECT_EQ(session.scene().history().steps().size(), 3u) << "it is kept";
    ASSERT_TRUE(notice());
    EXPECT_TRUE(notice()->stays);
    EXPECT_THAT(notice()->body, HasSubstr("Torus"));
    ASSERT_EQ(notice()->actions.size(), 1u);
    notice()->actions.front().act();
    EXPECT_EQ(position(), 3u);
    session.replace_scene(SceneFile());
    EXPECT_EQ(SceneFile(path).history().position(), 3u);
}

TEST_F(DeadlyScene, LosesMoreStepsWhenTheOneBeforeIsAsDeadly)
{
    die_at(path);
    die_at(path);
    testing::die_with([&] {
        static SceneFile scene(path);
        static LifeSign sign(folder, path, scene.lines().size());
        scene.undo();
        sign.take_back(scene.lines().size());
        sign.follow(scene.lines().size(), true);
    });
    session.replace_scene(SceneFile(path));
    EXPECT_EQ(position(), 0u);
}

TEST_F(DeadlyScene, LosesNothingByKillsWhileTheProgramWaits)
{
    for (int i = 0; i < 3; ++i) die_at(path, false);
    session.replace_scene(SceneFile(path));
    EXPECT_EQ(position(), 3u);
    EXPECT_FALSE(notice());
}

TEST_F(DeadlyScene, WithoutANameIsTakenUpWithoutItsLastStep)
{
    const std::string left = kept.file("untitled-1-1.trivar");
    testing::write_file(left, three_steps());
    die_at(left);
    die_at(left);
    recovery.take_up_left_scene();
    EXPECT_EQ(position(), 2u);
    EXPECT_TRUE(notice());
}

TEST_F(DeadlyScene, ThatIsACopyStaysAsItIsOnDisk)
{
    die_at(path);
    die_at(path);
    session.replace_scene(SceneFile::copy_of(path));
    EXPECT_EQ(position(), 2u);
    session.replace_scene(SceneFile());
    EXPECT_EQ(SceneFile(path).history().position(), 3u);
}

TEST_F(DeadlyScene, SignsThatItIsAtWorkUntilItIsEvaluated)
{
    session.replace_scene(SceneFile(path));
    const auto signs_work = [&] {
        for (const auto& each : std::filesystem::directory_iterator(folder))
            if (each.path().filename().string().starts_with(life_sign_name))
                return read_text_file(each.path().string()).starts_with("4 1");
        return false;
    };
    EXPECT_TRUE(signs_work());
    while (!session.up_to_date()) session.poll();
    session.be_at_work(false);
    EXPECT_FALSE(signs_work());
    session.be_at_work(true);
    EXPECT_TRUE(signs_work());
    session.propose(AddBox{});
    EXPECT_FALSE(signs_work()) << "no step is to blame for what a gesture does";
}

} // namespace
} // namespace trivar

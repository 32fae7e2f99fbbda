// SPDX-License-Identifier: GPL-3.0-or-later
// Windows that end at work on a scene, and others that are killed while they wait.
#include "core/base/text.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/simplify.h"
#include "core/scene/scene_file.h"
#include "tests/kill/screen.h"
#include "tests/kill/watched_program.h"
#include "tests/support/fixtures.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace trivar::testing {
namespace {

// A scene whose last step takes a window several seconds, or no time.
struct ScenesOfWindows : ::testing::Test {
    TemporaryFolder home;
    std::string path = home.file("scene.trivar");
    std::unique_ptr<Screen> screen = Screen::open();
    void SetUp() override
    {
        if (!screen) GTEST_SKIP() << "there is no Xvfb to show the window";
    }
    void make_scene(bool heavy) const
    {
        SceneFile scene;
        scene.run(AddBox{});
        AddSphere sphere;
        if (heavy) sphere.shape.segments = 1500, sphere.shape.rings = 750;
        scene.run(sphere);
        scene.run(Simplify{{2}, {}});
        scene.save_as(path);
    }
    // Opens the scene in a window; returns how many steps it has there.
    std::size_t opened_and_killed(bool idle) const
    {
        WatchedProgram window({path}, home.path().string(), screen->name());
        const bool shown = window.wait_for([&](const Shown& s) { return s.path == path; });
        EXPECT_TRUE(shown);
        constexpr int until_none_comes = 1000;
        if (idle)
            window.wait_for_frames(until_none_comes);
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
        window.kill();
        window.wait_till_gone();
        return shown ? window.shown().back().steps : 0;
    }
};

TEST_F(ScenesOfWindows, LoseTheStepAtWhichTwoOfThemEnded)
{
    make_scene(true);
    EXPECT_EQ(opened_and_killed(false), 3u);
    EXPECT_EQ(opened_and_killed(false), 3u);
    EXPECT_EQ(opened_and_killed(true), 2u);
    const SceneFile scene(path);
    EXPECT_EQ(scene.history().position(), 2u);
    EXPECT_EQ(scene.history().steps().size(), 3u) << "the step can be redone";
}

TEST_F(ScenesOfWindows, LoseNothingWhenTheyAreKilledWhileTheyWait)
{
    make_scene(false);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(opened_and_killed(true), 3u);
}

} // namespace
} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/primitives.h"
#include "core/scene/log.h"
#include "tests/kill/killed_scene.h"
#include "tests/kill/left_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

TEST(LeftFile, HoldsWhatWasShownAtAnyTimeBefore)
{
    const std::string text =
        log_header() + command_line(AddBox{}) + command_line(AddSphere{}) + undo_line();
    EXPECT_TRUE(holds(text, {.steps = 0, .of = 0, .lines = 1, .path = {}}));
    EXPECT_TRUE(holds(text, {.steps = 2, .of = 2, .lines = 3, .path = {}}));
    EXPECT_TRUE(holds(text, {.steps = 1, .of = 2, .lines = 4, .path = {}}));
    EXPECT_FALSE(holds(text, {.steps = 2, .of = 2, .lines = 5, .path = {}})); // one more
    EXPECT_FALSE(holds(text, {.steps = 2, .of = 2, .lines = 4, .path = {}})); // another
    EXPECT_THROW(holds(text + "{\"un", {.steps = 1, .of = 2, .lines = 4, .path = {}}), Rejected);
}

TEST(KilledWindow, HasShownNoStepThatIsMissingWhenItsSceneIsOpenedAgain)
{
    const auto screen = Screen::open();
    if (!screen) GTEST_SKIP() << "there is no Xvfb to show the window";
    const KillFindings found = kill_windows(*screen, 5, 1); // the last without a name
    EXPECT_GT(found.lines, 1u);                             // the keys were heard
    EXPECT_TRUE(found.faults.empty()) << fmt::format("{}", fmt::join(found.faults, "\n"));
}

} // namespace
} // namespace trivar::testing

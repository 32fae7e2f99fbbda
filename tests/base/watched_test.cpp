// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/watched.h"

#include "core/base/rejected.h"

#include <atomic>
#include <future>
#include <gtest/gtest.h>
#include <string>
#include <thread>

namespace trivar {
namespace {

TEST(Watched, GivesWhatTheWorkMakesAndItsProgress)
{
    double last = -1;
    std::string stage;
    const std::thread::id here = std::this_thread::get_id();
    const int made = watched(
        [](const Progress& inner) {
            report(inner, 0.5, "half");
            return 7;
        },
        [&](double fraction, std::string_view word) {
            EXPECT_EQ(std::this_thread::get_id(), here);
            last = fraction;
            stage = word;
        });
    EXPECT_EQ(made, 7);
    EXPECT_EQ(last, 0.5);
    EXPECT_EQ(stage, "half");
    EXPECT_EQ(watched([](const Progress& inner) { return !inner; }, {}), true); // right here
}

TEST(Watched, ThrowsWhatTheWorkThrows)
{
    const Progress hears = [](double, std::string_view) {};
    const auto run = [&] {
        return watched([](const Progress&) -> int { throw Rejected("no"); }, hears);
    };
    EXPECT_THROW(run(), Rejected);
}

TEST(Watched, LeavesWorkThatDoesNotReportAndTellsItToEnd)
{
    std::promise<void> let_go;
    const auto go = std::make_shared<std::shared_future<void>>(let_go.get_future().share());
    const auto told = std::make_shared<std::atomic<bool>>(false);
    const auto over = std::make_shared<std::promise<void>>();
    std::future<void> is_over = over->get_future();
    const auto run = [&] {
        run_watched(
            [go, told, over](const Progress& inner) {
                go->wait(); // says nothing for as long as it likes
                try {
                    report(inner, 1, "late");
                } catch (const Cancelled&) {
                    *told = true;
                }
                over->set_value();
            },
            [](double, std::string_view) { throw Cancelled(); });
    };
    EXPECT_THROW(run(), Cancelled);
    EXPECT_FALSE(*told);
    let_go.set_value();
    is_over.wait();
    EXPECT_TRUE(*told);
}

} // namespace
} // namespace trivar

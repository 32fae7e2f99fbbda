// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"
#include "core/base/ref.h"
#include "core/base/timing.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace trivar {
namespace {

TEST(Timings, AddUpByNameInTheOrderOfFirstAppearance)
{
    Timings a, b;
    a.add("rays", 2);
    a.add("springs", 3);
    b.add("lift", 1);
    b.add("rays", 5);
    a.add(b);
    ASSERT_EQ(a.stages.size(), 3u);
    EXPECT_EQ(a.stages[0].name, "rays");
    EXPECT_EQ(a.stages[0].time_ms, 7);
    EXPECT_EQ(a.stages[2].name, "lift");
}

TEST(Timings, WatchReturnsWhatTheBodyReturns)
{
    Timings timings;
    EXPECT_EQ(timed(timings, "sum", [] { return 2 + 3; }), 5);
    timed(timings, "nothing", [] {});
    ASSERT_EQ(timings.stages.size(), 2u);
    EXPECT_GE(timings.stages[0].time_ms, 0);
}

TEST(Timings, WatchNotesAStageThatThrows)
{
    Timings timings;
    EXPECT_THROW(timed(timings, "fails", [] { throw std::runtime_error("no"); }),
                 std::runtime_error);
    EXPECT_EQ(timings.stages.size(), 1u);
}

TEST(Progress, OfNobodyIsSilence)
{
    EXPECT_NO_THROW(report({}, 0.5, "stage"));
    double seen = 0;
    report([&](double fraction, std::string_view) { seen = fraction; }, 0.5, "stage");
    EXPECT_EQ(seen, 0.5);
}

TEST(Ref, IsUnchangedWhileItIsTheSamePointer)
{
    const Ref<int> a = make_ref(3), b = a, c = make_ref(3);
    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
    EXPECT_EQ(*a, *c);
}

} // namespace
} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/mistake.h"

#include "core/base/rejected.h"

#include <gmock/gmock.h>
#include <new>
#include <optional>
#include <system_error>

namespace trivar {
namespace {

using ::testing::HasSubstr;

TEST(Mistakes, SayWhatDoesNotHoldAndWhere)
{
    EXPECT_NO_THROW(ensure(true, "nothing"));
    try {
        ensure(2 < 1, "two is below one");
        FAIL();
    } catch (const Mistake& mistake) {
        const std::string line = std::to_string(__LINE__ - 3);
        EXPECT_EQ(words_of(mistake), "Trivar made a mistake here: two is below one "
                                     "(mistake_test.cpp:" +
                                         line + ")");
    }
}

TEST(Mistakes, AreAllExceptionsButThoseOfDataMemoryAndTheSystem)
{
    EXPECT_TRUE(is_mistake(Mistake("a")));
    EXPECT_TRUE(is_mistake(std::bad_optional_access()));
    EXPECT_TRUE(is_mistake(std::out_of_range("a")));
    EXPECT_FALSE(is_mistake(Rejected("a")));
    EXPECT_FALSE(is_mistake(Cancelled()));
    EXPECT_FALSE(is_mistake(std::bad_alloc()));
    EXPECT_FALSE(
        is_mistake(std::system_error(std::make_error_code(std::errc::no_space_on_device))));
}

TEST(Mistakes, AreToldInOneLine)
{
    EXPECT_EQ(words_of(Rejected("no")), "no");
    EXPECT_EQ(words_of(std::bad_alloc()), "There is not enough memory for it");
    EXPECT_THAT(words_of(std::logic_error("of\ntwo lines")), HasSubstr("here: of two lines"));
}

} // namespace
} // namespace trivar

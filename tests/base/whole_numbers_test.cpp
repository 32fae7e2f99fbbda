// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/whole_numbers.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;

TEST(WholeNumbers, AreReadBetweenMarks)
{
    EXPECT_THAT(whole_numbers("1:240:2", ':'), ElementsAre(1, 240, 2));
    EXPECT_THAT(whole_numbers("1280x720", 'x'), ElementsAre(1280, 720));
    EXPECT_THAT(whole_numbers("-3", ':'), ElementsAre(-3));
}

TEST(WholeNumbers, AreNoneWhereThereIsAnythingElse)
{
    for (const char* text :
         {"", ":", "1:", ":1", "1::2", "1 :2", "1:2 ", "1.5", "1:x", "+1", "99999999999", "1/2"})
        EXPECT_THAT(whole_numbers(text, ':'), IsEmpty()) << text;
}

} // namespace
} // namespace trivar

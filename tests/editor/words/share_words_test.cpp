// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/share_words.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(ShareWords, SayPerCentWithoutPowersOfTen)
{
    EXPECT_EQ(share_words(1.1), "110 %");
    EXPECT_EQ(share_words(25.4), "2540 %");
    EXPECT_EQ(share_words(0.5), "50 %");
    EXPECT_EQ(share_words(0.0041), "0.41 %");
    EXPECT_EQ(share_words(1e-7), "under 0.01 %");
}

} // namespace
} // namespace trivar

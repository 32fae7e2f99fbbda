// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/base/utf8.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Utf8, GivesEachLetterWithItsBytes)
{
    EXPECT_EQ(first_letter("az").number, U'a');
    EXPECT_EQ(first_letter("\u00e9").number, U'\u00e9');
    EXPECT_EQ(first_letter("\u20ac!").bytes, 3u);
    EXPECT_EQ(first_letter("\U0001f40d").number, U'\U0001f40d');
    EXPECT_EQ(first_letter(std::string_view("\0", 1)).bytes, 1u);
}

TEST(Utf8, IsNotWhatIsCutOffOverlongASurrogateOrTooLarge)
{
    for (const char* bytes :
         {"\x80", "\xff", "\xc3", "\xe2\x82", "\xc3(", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
          "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"}) {
        EXPECT_EQ(first_letter(bytes).bytes, 0u);
        EXPECT_FALSE(is_utf8(std::string("a") + bytes));
    }
    EXPECT_TRUE(is_utf8("\u00e9\u20ac\U0001f40d"));
    EXPECT_TRUE(is_utf8(""));
}

TEST(Printable, ShowsWhatIsNoLetterAsAQuestionMark)
{
    EXPECT_EQ(printable("caf\u00e9 \U0001f40d"), "caf\u00e9 \U0001f40d");
    EXPECT_EQ(printable("a\nb\x1b[2J\x7f"), "a?b?[2J?");
    EXPECT_EQ(printable("\u009b2J"), "?2J");
    EXPECT_EQ(printable("\xff\xfe\xc3"), "???");
    EXPECT_TRUE(is_utf8(printable("\xe2\x82\u20ac\x80")));
}

TEST(Excerpt, IsShortAndEndsAfterAWholeLetter)
{
    EXPECT_EQ(excerpt("short\t"), "short?");
    for (std::size_t before = 0; before < 4; ++before) {
        std::string text(before, 'a');
        for (int i = 0; i < 100; ++i) text += "\U0001f40d";
        EXPECT_LE(excerpt(text).size(), 63u);
        EXPECT_EQ(excerpt(text).find('?'), std::string::npos);
        EXPECT_TRUE(excerpt(text).ends_with("\U0001f40d..."));
    }
}

TEST(ShortSentence, KeepsItsEndWhereWhatIsWrongStands)
{
    EXPECT_EQ(short_sentence("a\nb: there is no such file"), "a?b: there is no such file");
    const std::string told = short_sentence(std::string(4000, 'a') + ": there is no such file");
    EXPECT_TRUE(told.starts_with("...aaa"));
    EXPECT_TRUE(told.ends_with("a: there is no such file"));
    EXPECT_LT(told.size(), 400u);
}

} // namespace
} // namespace trivar

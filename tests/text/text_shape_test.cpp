// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_shape.h"

#include "core/base/rejected.h"
#include "core/mesh/closed_body.h"
#include "core/text/installed_fonts.h"
#include "core/text/letters.h"
#include "tests/mesh/edges.h"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace trivar;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

const Font& sans()
{
    static const Font font = find_font("DejaVu Sans").font;
    return font;
}

TextBody body_of(const std::string& text, const Font& font = sans())
{
    return text_body({.text = text}, font);
}

std::string refusal(const TextShape& shape)
{
    try {
        check(shape);
    } catch (const Rejected& why) {
        return why.what();
    }
    return {};
}

std::vector<unsigned> glyphs(const Font& font, std::u32string_view letters)
{
    std::vector<unsigned> result;
    for (const Font::PlacedGlyph& put : font.line(letters, 0).glyphs) result.push_back(put.glyph);
    return result;
}

std::string file_of(const std::string& name)
{
    for (const InstalledFont& font : installed_fonts())
        if (font.title() == name) return font.path;
    return {};
}

std::string bytes_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST(Text, IsLettersThatAreEachClosed)
{
    const TextBody body = body_of("Hej, Åsa!\nÉté — שלום سلام");
    EXPECT_THAT(body.notices, IsEmpty());
    const auto edges = trivar::testing::count_edges(body.mesh);
    EXPECT_EQ(edges.open + edges.against + edges.crowded, 0);
    EXPECT_TRUE(is_closed_body(body.mesh));
    validate(body.mesh, "text");
}

TEST(Text, BeginsEachLineBelowTheOneBefore)
{
    const Box one = bounding_box(body_of("H").mesh), two = bounding_box(body_of("H\r\nH").mesh);
    EXPECT_NEAR(one.lo.y - two.lo.y, sans().line_height() * 0.5, 1e-6);
    EXPECT_EQ(one.hi.y, two.hi.y);
}

TEST(Text, StandsLeftInTheMiddleOrRightOfItsOrigin)
{
    TextShape shape{.text = "HHH\nH"};
    const Box left = bounding_box(text_body(shape, sans()).mesh);
    shape.align = TextAlign::right;
    const Box right = bounding_box(text_body(shape, sans()).mesh);
    shape.align = TextAlign::center;
    const Box middle = bounding_box(text_body(shape, sans()).mesh);
    EXPECT_GE(left.lo.x, 0);
    EXPECT_LE(right.hi.x, 0);
    EXPECT_NEAR(middle.lo.x + middle.hi.x, 0, 1e-3);
    EXPECT_NEAR(left.size().x, middle.size().x, 1e-6);
}

TEST(Text, GrowsWithItsSizeAndSpreadsWithItsSpacing)
{
    const Box once = bounding_box(text_body({.text = "ab", .size = 1}, sans()).mesh);
    const Box twice = bounding_box(text_body({.text = "ab", .size = 2, .depth = 0.2}, sans()).mesh);
    EXPECT_NEAR(twice.size().x, 2 * once.size().x, 1e-5);
    const Box wide =
        bounding_box(text_body({.text = "ab", .size = 1, .letter_spacing = 0.25}, sans()).mesh);
    EXPECT_NEAR(wide.size().x - once.size().x, 0.25, 1e-5);
}

TEST(Text, PutsAccentsOnTheirLetters)
{
    EXPECT_EQ(glyphs(sans(), U"e\u0301"), glyphs(sans(), U"é"));
    const Box plain = bounding_box(body_of("x").mesh),
              marked = bounding_box(body_of("x\u0301").mesh);
    EXPECT_GT(marked.hi.y, plain.hi.y + 0.05);
    EXPECT_NEAR(marked.hi.x, plain.hi.x, 0.02); // it stands above, not behind
}

TEST(Text, TakesLigaturesUnlessLettersAreSpread)
{
    EXPECT_EQ(sans().line(U"ffi", 0).glyphs.size(), 1u);
    EXPECT_EQ(sans().line(U"ffi", 1000).glyphs.size(), 3u);
}

TEST(Text, ReadsFromRightToLeftWhereItsScriptDoes)
{
    const std::vector<unsigned> word = glyphs(sans(), U"אבג");
    const std::vector<unsigned> turned{glyphs(sans(), U"ג")[0], glyphs(sans(), U"ב")[0],
                                       glyphs(sans(), U"א")[0]};
    EXPECT_EQ(word, turned);
    // Numbers in it still read from left to right, and what is Latin stays in its order.
    const std::vector<unsigned> mixed = glyphs(sans(), U"א12b");
    EXPECT_THAT(mixed, ElementsAre(glyphs(sans(), U"1")[0], glyphs(sans(), U"2")[0],
                                   glyphs(sans(), U"b")[0], glyphs(sans(), U"א")[0]));
}

TEST(Text, JoinsArabicLetters)
{
    const std::vector<unsigned> word = glyphs(sans(), U"سلام");
    const unsigned alone = glyphs(sans(), U"س")[0];
    EXPECT_EQ(word.size(), 3u);    // lam and alef are one
    EXPECT_NE(word.back(), alone); // the first letter, which joins the next
}

TEST(Text, ShowsABoxForALetterThatTheFontLacksAndSaysSo)
{
    const Font inter = find_font("Inter").font;
    const TextBody body = body_of("aשbש", inter);
    EXPECT_THAT(
        body.notices,
        ElementsAre(
            "Inter Regular lacks one letter of the text: ש (U+05E9); a box is shown for each"));
    EXPECT_THAT(body_of("a\U0001F600", inter).notices, // what reads this may lack it as well
                ElementsAre(::testing::HasSubstr("one letter of the text: U+1F600; a box")));
    EXPECT_GT(body.mesh.face_count(), body_of("ab", inter).mesh.face_count());
    EXPECT_TRUE(is_closed_body(body.mesh));
}

TEST(Text, NamesTheLettersOfAClusterThatTheFontLacksAndNoOthers)
{
    EXPECT_THAT(body_of("Z\u0351\u036B\u0343\u036A").notices, // the letter and two marks are there
                ElementsAre(HasSubstr("2 letters of the text: U+036B, U+036A; a box")));
    // Three that joiners hold together; what says how one is drawn is no letter either.
    const Font inter = find_font("Inter").font;
    EXPECT_THAT(body_of("\U0001F468\u200D\U0001F469\u200D\U0001F467\uFE0F", inter).notices,
                ElementsAre(HasSubstr("3 letters of the text: U+1F468, U+1F469, U+1F467; a box")));
    EXPECT_THAT(body_of("สวัสดี", inter).notices,
                ElementsAre(HasSubstr("5 letters of the text: U+0E2A, U+0E27, U+0E31, U+0E14, "
                                      "U+0E35; a box")));
}

TEST(Text, KeepsChordsWithinTheTolerance)
{
    // A finer text of a round letter is nowhere farther from the coarse one than the tolerance
    // says: chords lie inside an O's outer edge, so its area differs by at most perimeter x
    // tolerance.
    const unsigned o = glyphs(sans(), U"o")[0];
    const auto fine = sans().glyph(o, 0.00001 * em_units).loops;
    for (const double tolerance : {0.003, 0.001, 0.0003}) {
        const auto coarse = sans().glyph(o, tolerance * em_units).loops;
        EXPECT_LT(coarse[0].size(), fine[0].size());
        for (const glm::ivec2& p : fine[0]) { // distance to the coarse polygon
            double nearest = 1e9;
            for (std::size_t i = 0; i < coarse[0].size(); ++i) {
                const glm::dvec2 a(coarse[0][i]), b(coarse[0][(i + 1) % coarse[0].size()]);
                const double length = glm::dot(b - a, b - a);
                const double t =
                    length > 0 ? glm::clamp(glm::dot(glm::dvec2(p) - a, b - a) / length, 0.0, 1.0)
                               : 0;
                nearest = std::min(nearest, glm::distance(a + (b - a) * t, glm::dvec2(p)));
            }
            EXPECT_LE(nearest, tolerance * em_units + 2);
        }
    }
}

TEST(Text, SaysInASentenceWhatItRefuses)
{
    EXPECT_EQ(refusal({.text = ""}), "the text has no letters");
    EXPECT_EQ(refusal({.text = " \n\t \u3000"}), "the text has no letters");
    EXPECT_EQ(refusal({.text = "a\xFFz"}), "the text is not UTF-8");
    EXPECT_EQ(refusal({.text = "a\xC0\x80"}), "the text is not UTF-8");
    EXPECT_EQ(refusal({.text = std::string(100000, 'x')}),
              "the text has 100,000 letters but at most 2,000 are allowed");
    EXPECT_EQ(refusal({.text = "a\ab"}),
              "the text holds the control character U+0007; only line breaks and tabs are allowed");
    EXPECT_EQ(refusal({.text = "a", .size = 0.001}),
              "the depth of a text is at most 20 times its size");
    EXPECT_EQ(refusal({.text = "a\tb\r\nc"}), "");
}

TEST(Text, RefusesMoreFacesThanAnyoneCanBend)
{
    EXPECT_THROW(text_body({.text = std::string(2000, '@'), .max_edge = 0.01}, sans()), Rejected);
}

TEST(Text, LetsMarksAndSignsOfAllKindsPass)
{
    const TextBody body = body_of("\u202Eabc\u202C \u0301\u0301\u0301 \U0001F600 \uFFFD\u200D");
    EXPECT_TRUE(is_closed_body(body.mesh));
}

TEST(Text, ReadsBackWhatItWroteAsUtf8)
{
    for (const char32_t letter : {U'a', U'é', U'ש', U'\uFFFD', U'\U0001F600'})
        EXPECT_EQ(letters_of(utf8_of(letter)), std::u32string(1, letter));
}

TEST(Fonts, AreFoundByFamilyStyleOrFile)
{
    EXPECT_EQ(find_font("dejavu sans").font.title(), "DejaVu Sans Book");
    EXPECT_EQ(find_font("DejaVu Sans Bold").font.title(), "DejaVu Sans Bold");
    const std::string path = file_of("DejaVu Sans Bold");
    EXPECT_EQ(find_font(path).font.title(), "DejaVu Sans Bold");
    EXPECT_EQ(find_font(path).font.digest(), find_font("DejaVu Sans Bold").font.digest());
}

TEST(Fonts, HaveOneStandInForThoseThatAreNotThere)
{
    EXPECT_THAT(find_font("No Such Font").notices,
                ElementsAre("the font \"No Such Font\" is not on this computer: DejaVu Sans Book "
                            "is used instead"));
    EXPECT_THAT(
        find_font("/no/such.ttf").notices,
        ElementsAre("the font /no/such.ttf cannot be opened: DejaVu Sans Book is used instead"));
    EXPECT_EQ(find_font("").notices.size(), 1u);
    EXPECT_EQ(find_font("/").notices.size(), 1u);
    EXPECT_EQ(find_font("/dev/zero").notices.size(), 1u);
}

TEST(Fonts, SayWhenTheFileIsAnotherOne)
{
    EXPECT_THAT(text_body({.text = "a", .font_digest = "0"}, sans()).notices,
                ElementsAre(HasSubstr("is another version than the scene was made with")));
    EXPECT_THAT(text_body({.text = "a", .font_digest = sans().digest()}, sans()).notices,
                IsEmpty());
}

// Every byte of a small font's head damaged in turn, and the font cut off: boxes or a sentence.
TEST(Fonts, ThatAreDamagedAreBoxesOrRefused)
{
    EXPECT_THROW(Font("", 0, "x"), Rejected);
    EXPECT_THROW(Font("not a font", 0, "x"), Rejected);
    const std::string good = bytes_of(file_of("DejaVu Sans Mono Bold"));
    ASSERT_FALSE(good.empty());
    int survived = 0;
    std::uint32_t random = 12345;
    for (int i = 0; i < 300; ++i) {
        std::string bad = good;
        for (int k = 0; k < 20; ++k) {
            random = random * 1664525u + 1013904223u;
            const std::size_t within = i % 2 == 0 ? 2000 : bad.size();
            bad[(random >> 8) % within] = static_cast<char>(random);
        }
        if (i % 7 == 0) bad.resize((random >> 4) % bad.size());
        try {
            const TextBody body = body_of("aB§é", Font(bad, 0, "bad"));
            EXPECT_TRUE(body.mesh.face_count() == 0 || is_closed_body(body.mesh)) << i;
            ++survived;
        } catch (const Rejected&) {
        }
    }
    EXPECT_GT(survived, 20);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/palette.h"

#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

struct Pair {
    const char* what;
    Color text, ground;
    double least;
};

// The least contrasts are those of the specification's table of tokens (WCAG 2.1 AA is 4.5).
std::vector<Pair> pairs(const Palette& c)
{
    std::vector<Pair> result;
    for (const Color ground : {c.base, c.panel, c.header, c.raised, c.field}) {
        result.push_back({"text", c.text, ground, 7.8});
        result.push_back({"text_2", c.text_2, ground, 4.6});
    }
    for (const Color ground : {c.base, c.panel, c.header, c.raised})
        result.push_back({"text_3", c.text_3, ground, 4.6});
    result.push_back({"text on a selected row", c.text, c.row_selected, 7.8});
    result.push_back({"text_2 on a selected row", c.text_2, c.row_selected, 4.6});
    for (const Color ground :
         {c.accent, c.accent_hover, c.accent_active, c.bad_fill, c.bad_fill_hover})
        result.push_back({"on_accent", c.on_accent, ground, 4.6});
    for (const Color meaning : {c.good, c.warn, c.bad, c.accent_text})
        result.push_back({"meaning", meaning, c.panel, 4.5});
    return result;
}

TEST(Palette, EveryTextIsReadableWhereItIsAllowed)
{
    for (const Palette& palette : {dark_palette(), light_palette()})
        for (const Pair& pair : pairs(palette))
            EXPECT_GE(contrast(pair.text, pair.ground), pair.least)
                << pair.what << std::hex << " " << pair.text << " on " << pair.ground;
}

TEST(Palette, ContrastOfBlackAndWhiteIsTwentyOne)
{
    EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xFFFFFF)), 21, 1e-9); // WCAG 2.1, definition
    EXPECT_NEAR(contrast(rgb(0x777777), rgb(0xFFFFFF)), 4.48, 0.005);
}

TEST(Palette, AColourIsWrittenAsInTheSpecification)
{
    EXPECT_EQ(rgb(0x112233), 0xFF332211u);
    EXPECT_EQ(faded(rgb(0x112233), 0.5f) >> 24, 127u);
}

} // namespace
} // namespace trivar::ui

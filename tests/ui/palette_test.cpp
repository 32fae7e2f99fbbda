// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/palette.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace trivar::ui {
namespace {

struct Pair {
    const char* what;
    Color text, ground;
    double least;
};

// Contrast of two opaque colours, 1..21 (WCAG 2.1, relative luminance).
double contrast(Color a, Color b)
{
    const auto luminance = [](Color color) {
        return glm::dot(glm::dvec3(linear_light(color)), {0.2126, 0.7152, 0.0722});
    };
    const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

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
    for (const Color letter : {c.letter_x, c.letter_y, c.letter_z})
        result.push_back({"letter of an axis", letter, c.field, 4.2});
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

TEST(Palette, WithHighContrastNoTextIsQuieterThanAnother)
{
    for (const bool light : {false, true}) {
        const Palette c = palette_of({.light = light, .high_contrast = true});
        for (const Color ground : {c.base, c.panel, c.header, c.raised, c.field, c.row_selected})
            for (const Color text : {c.text, c.text_2, c.text_3})
                EXPECT_GE(contrast(text, ground), 7.8);
    }
}

TEST(Palette, DotsAndBarsReadOnWhatTheyLieOn)
{
    constexpr double least = 3; // WCAG 2.1, of what is no text
    for (const Palette& c : {dark_palette(), light_palette()}) {
        EXPECT_GE(contrast(c.chip_text, c.chip), least); // the rim of a chip's dot
        for (const Color dot : {c.good, c.warn, c.bad})
            EXPECT_GE(std::max(contrast(dot, c.chip), contrast(dot, c.chip_text)), least)
                << std::hex << dot;
        for (const Color bar : {c.cpu, c.gpu}) EXPECT_GE(contrast(bar, c.field), least);
        EXPECT_GE(contrast(c.text_3, c.raised), least); // the rim of the legend's colours
    }
}

// The least difference between any two overlays that can be seen together.
double least_difference(const Palette& c, Eyes eyes)
{
    const Color overlays[] = {c.lattice, c.stroke, c.sphere, c.incision, c.fold, c.path};
    double least = 1e9;
    for (const Color a : overlays)
        for (const Color b : overlays)
            if (a != b) least = std::min(least, difference(a, b, eyes));
    return least;
}

TEST(Palette, OverlaysDifferForEyesThatLackAColour)
{
    for (const Palette& palette : {dark_palette(), light_palette()}) {
        for (const Eyes eyes : {Eyes::usual, Eyes::protanopia, Eyes::deuteranopia})
            EXPECT_GE(least_difference(palette, eyes), 22) << static_cast<int>(eyes);
        EXPECT_GE(least_difference(palette, Eyes::tritanopia), 15);
    }
    EXPECT_GE(least_difference(light_palette(), Eyes::tritanopia), 20);
}

TEST(Palette, OverlaysOfTheLightThemeStandOutFromItsSky)
{
    const Palette c = light_palette();
    for (const Color overlay :
         {c.lattice, c.stroke, c.sphere, c.incision, c.fold, c.path, c.contact})
        for (const Color sky : {c.sky_top, c.sky_bottom}) EXPECT_GE(contrast(overlay, sky), 2.2);
}

TEST(Palette, OtherHuesDifferMoreForEyesOfEveryKind)
{
    for (const bool light : {false, true})
        for (const Eyes eyes :
             {Eyes::usual, Eyes::protanopia, Eyes::deuteranopia, Eyes::tritanopia})
            EXPECT_GE(least_difference(palette_of({.light = light, .other_hues = true}), eyes), 30)
                << light << static_cast<int>(eyes);
}

TEST(Palette, DifferenceIsTheDistanceInLab)
{
    EXPECT_NEAR(difference(rgb(0), rgb(0xFFFFFF), Eyes::usual), 100, 0.1);
    // Red and green of one lightness: far apart for most, near for deuteranopes.
    EXPECT_GT(difference(rgb(0xC85050), rgb(0x608C3C), Eyes::usual),
              2 * difference(rgb(0xC85050), rgb(0x608C3C), Eyes::deuteranopia));
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

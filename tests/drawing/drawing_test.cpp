// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/drawing/drawing_file.h"
#include "core/drawing/hand_edits.h"
#include "core/drawing/svg.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// Two lines, the second one hidden, whose slopes and depths grow from 0 to 99.
std::vector<Stroke> two_lines()
{
    std::vector<Stroke> out(2);
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<float>(i);
        out[0].points.push_back({.at = {x, 10}, .depth = x, .slope = x, .p = {x / 2, 10, 0}});
        out[1].points.push_back({.at = {x, 20}, .depth = x, .slope = x, .p = {x / 2, 20, 5}});
    }
    out[0].id = 0xabc;
    out[1].id = 0x12;
    out[1].hidden = true;
    return out;
}

DrawingSheet two_line_drawing(const LineStyle& style = {.taper = 0, .hidden = HiddenLines::faint})
{
    return {{{"bone & skin", inked(two_lines(), style)}}, {640, 480}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

TEST(Svg, HasALayerForEachLevelWithIdsThatStay)
{
    const std::vector<InkedLine> lines = inked(two_lines(), {.hidden = HiddenLines::dashed});
    const std::vector<DrawingLayer> layers{{"bone & skin", lines}, {"", {}}};
    const std::string text = svg_of({layers, {640, 480}});
    EXPECT_THAT(text, HasSubstr("viewBox=\"0 0 640 480\""));
    EXPECT_THAT(text, HasSubstr("inkscape:label=\"bone &amp; skin\""));
    EXPECT_THAT(text, HasSubstr("id=\"bone---skin-sabc\""));
    EXPECT_THAT(text, HasSubstr("id=\"bone---skin-hidden\""));
    EXPECT_THAT(text, HasSubstr("stroke-dasharray"));
    EXPECT_THAT(text, HasSubstr("<rect"));
    EXPECT_THAT(svg_of({layers, {640, 480}, std::nullopt}), Not(HasSubstr("<rect")));
}

TEST(Svg, HasAPathForEachPieceOfOneColor)
{
    const std::string plain = svg_of({{{"a", inked(two_lines(), {.taper = 0})}}, {100, 100}});
    const std::string hues =
        svg_of({{{"a", inked(two_lines(), {.color_by = LineColor::hue_by_slope, .taper = 0})}},
                {100, 100}});
    const auto paths = [](const std::string& text) {
        std::size_t out = 0;
        for (std::size_t at = text.find("<path"); at != text.npos; at = text.find("<path", at + 1))
            ++out;
        return out;
    };
    EXPECT_EQ(paths(plain), 1u);
    EXPECT_GT(paths(hues), 20u);
    EXPECT_THAT(plain, HasSubstr("d=\"M0 10 1 10 2 10"));
}

TEST(DrawingFiles, AreAllThatTheirNamesSay)
{
    const DrawingSheet drawing = two_line_drawing();
    const auto bytes = [&](const char* path) {
        return drawing_bytes(drawing, drawing_format(path));
    };
    EXPECT_THAT(bytes("a.svg"), StartsWith("<svg"));
    EXPECT_THAT(bytes("a.pdf"), StartsWith("%PDF"));
    EXPECT_THAT(bytes("a.png"), StartsWith("\x89PNG"));
    EXPECT_THAT(bytes("a.obj"), HasSubstr("\nv 49.5 10 0\n"));
    EXPECT_EQ(bytes("a.pdf"), bytes("b.pdf"));
    for (const char* path : {"a.jpg", "svg", ""}) EXPECT_THROW(drawing_format(path), Rejected);
}

TEST(HandEdits, AreNoneOfADrawingThatIsAsItWasWritten)
{
    const HandEdits edits = read_hand_edits(svg_of(two_line_drawing()));
    EXPECT_TRUE(edits.by_line.empty());
    EXPECT_EQ(edits.added, 0u);
    ASSERT_EQ(edits.lines.at("bone---skin").size(), 2u);
}

TEST(HandEdits, KeepDeletionsWidthsAndColors)
{
    const DrawingSheet drawing = two_line_drawing();
    const std::string text = svg_of(drawing);
    // As Inkscape saves it: the width and the colour in a style, the attribute as it was.
    const std::string edited =
        replaced(text, "<path id=\"bone---skin-sabc\"",
                 "<path id=\"bone---skin-sabc\" style=\"stroke-width: 5.4; stroke:#ff0000\"");
    DrawingSheet again = drawing;
    apply(read_hand_edits(edited), again);
    ASSERT_EQ(again.layers[0].lines.size(), 2u);
    EXPECT_NEAR(again.layers[0].lines[1].points[50].width, 5.4, 1e-3);
    EXPECT_EQ(again.layers[0].lines[1].points[50].color, glm::vec3(1, 0, 0));

    const std::string hidden = replaced(text, "<path id=\"bone---skin-h12\"",
                                        "<path display=\"none\" id=\"bone---skin-h12\"");
    again = drawing;
    apply(read_hand_edits(hidden), again);
    ASSERT_EQ(again.layers[0].lines.size(), 1u);
    EXPECT_FALSE(again.layers[0].lines[0].hidden);
}

TEST(HandEdits, GoWithALineThatMoved)
{
    const std::string edited =
        replaced(svg_of(two_line_drawing()), "stroke-width=\"1.80\"", "stroke-width=\"0.90\"");
    const HandEdits edits = read_hand_edits(edited);
    std::vector<Stroke> moved = two_lines();
    for (Stroke& stroke : moved) {
        stroke.id += 1000; // as of another mesh
        for (StrokePoint& p : stroke.points) p.p += glm::vec3(0.3f, 0.5f, 0);
    }
    LineIds ids = edits.ids_of("bone & skin");
    ids(std::span(&moved, 1));
    EXPECT_EQ(moved[0].id, 0xabcu);
    EXPECT_EQ(moved[1].id, 0x12u);
    DrawingSheet drawing{{{"bone & skin", inked(moved, {.taper = 0})}}, {640, 480}};
    apply(edits, drawing);
    EXPECT_NEAR(drawing.layers[0].lines[0].points[0].width, 0.9, 1e-3);
}

TEST(HandEdits, SayWhatIsNoDrawing)
{
    for (const char* text :
         {"", "<svg", "<svg/>", "<svg><desc id=\"x\">a</desc></svg>", "\xff\xfe"})
        EXPECT_THROW(read_hand_edits(text), Rejected) << text;
    const HandEdits edits =
        read_hand_edits("<svg><path id=\"mine\"/><desc id=\"trivar-lines\">\na-sx 1 #000 1\n"
                        "b-s1 nan #000000 1 2 3\nc-s2 1 #000000 9e99 2 3\n\n-- \n</desc></svg>");
    EXPECT_EQ(edits.added, 1u);
    EXPECT_EQ(edits.by_line.size(), 1u); // c, which is gone
}

} // namespace
} // namespace trivar::testing

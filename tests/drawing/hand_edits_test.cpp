// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing/hand_edits.h"

#include "core/base/rejected.h"
#include "core/drawing/svg.h"
#include "tests/drawing/two_lines.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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
    // Inkscape saves the width and the colour in a style, the attribute as it was.
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
    EditedLineIds ids(edits);
    ids("bone & skin")(std::span(&moved, 1));
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

// Reads what a hand did to a text, draws the same lines, and writes them as a text again.
std::string drawn_again(const std::string& edited, DrawingSheet drawing)
{
    apply(read_hand_edits(edited), drawing);
    return svg_of(drawing);
}

TEST(HandEdits, AreStillThereAfterManyDrawings)
{
    const DrawingSheet drawing = two_line_drawing();
    std::string text = without_path(svg_of(drawing), "bone---skin-h12");
    text = replaced(text, "stroke-width=\"1.80\"", "stroke-width=\"3.60\"");
    for (int i = 0; i < 3; ++i) text = drawn_again(text, drawing);
    EXPECT_THAT(text, Not(HasSubstr("<path id=\"bone---skin-h12\"")));
    EXPECT_THAT(text, HasSubstr("stroke-width=\"3.60\""));
    text = replaced(text, "stroke=\"#0d0d12\"", "stroke=\"#ff0000\""); // one more
    for (int i = 0; i < 2; ++i) text = drawn_again(text, drawing);
    EXPECT_THAT(text, Not(HasSubstr("<path id=\"bone---skin-h12\"")));
    EXPECT_THAT(text, HasSubstr("stroke=\"#ff0000\" stroke-width=\"3.60\""));
}

TEST(HandEdits, AreKeptOfDeletedLinesThatAreNotSeenForAWhile)
{
    const DrawingSheet drawing = two_line_drawing();
    DrawingSheet turned = drawing;
    turned.layers[0].lines.pop_back(); // the one that is seen
    std::string text = without_path(svg_of(drawing), "bone---skin-sabc");
    text = drawn_again(drawn_again(text, turned), drawing);
    EXPECT_THAT(text, Not(HasSubstr("<path id=\"bone---skin-sabc\"")));
    EXPECT_THAT(text, HasSubstr("<path id=\"bone---skin-h12\""));
}

TEST(HandEdits, AreNoneOfLinesInPiecesOfManyColors)
{
    const DrawingSheet drawing =
        two_line_drawing({.color_by = LineColor::hue_by_slope, .taper = 0});
    EXPECT_TRUE(read_hand_edits(svg_of(drawing)).by_line.empty());
}

TEST(HandEdits, KeepLayersApartWhoseNamesGiveOneId)
{
    const std::vector<InkedLine> lines = inked(two_lines(), {.taper = 0});
    const DrawingSheet drawing{{{"bone 1", lines}, {"bone_1", lines}, {"bone 1", lines}}, {9, 9}};
    const std::string text = svg_of(drawing);
    for (const char* id : {"bone-1", "bone-1.2", "bone-1.3"})
        EXPECT_THAT(text, HasSubstr(std::string("<g id=\"") + id + "\""));
    DrawingSheet again = drawing;
    apply(read_hand_edits(without_path(text, "bone-1.2-sabc")), again);
    EXPECT_EQ(again.layers[0].lines.size(), 1u);
    EXPECT_EQ(again.layers[1].lines.size(), 0u);
    EXPECT_EQ(again.layers[2].lines.size(), 1u);
}

TEST(HandEdits, OfAnOutlineAddTheStrokeThatAHandGaveIt)
{
    const DrawingSheet drawing =
        two_line_drawing({.width = 2.6f, .width_by = LineWidth::by_slope, .taper = 0});
    const std::string own = "<path id=\"bone---skin-sabc\" fill=\"#0d0d12\" stroke=\"none\"",
                      text = svg_of(drawing);
    const float width = drawing.layers[0].lines[0].points[50].width;
    const auto again = [&](const std::string& edited) {
        DrawingSheet out = drawing;
        apply(read_hand_edits(edited), out);
        return out.layers[0].lines[0].points[50];
    };
    const std::string stroked =
        replaced(text, own, own + " style=\"stroke:#00ff00;stroke-width:0.5\"");
    EXPECT_NEAR(again(stroked).width, width + 0.5, 0.02);
    EXPECT_EQ(again(stroked).color, drawing.layers[0].lines[0].points[50].color);
    EXPECT_NEAR(again(drawn_again(stroked, drawing)).width, width + 0.5, 0.02);
    const std::string filled = replaced(text, own, own + " style=\"fill:#0000ff\"");
    EXPECT_EQ(again(filled).color, glm::vec3(0, 0, 1));
    EXPECT_EQ(again(filled).width, width);
}

} // namespace
} // namespace trivar::testing

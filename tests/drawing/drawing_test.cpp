// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/drawing/drawing_file.h"
#include "core/drawing/line_pieces.h"
#include "core/drawing/svg.h"
#include "tests/drawing/two_lines.h"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Svg, HasALayerForEachLevelWithIdsThatStay)
{
    const std::vector<InkedLine> lines = inked(two_lines(), {.hidden = HiddenLines::dashed});
    const std::vector<DrawingLayer> layers{{"bone & skin", lines}, {"", {}}};
    const std::string text = svg_of({layers, {640, 480}});
    EXPECT_THAT(text, HasSubstr("viewBox=\"0 0 640 480\""));
    EXPECT_THAT(text, HasSubstr("inkscape:label=\"bone &amp; skin\""));
    EXPECT_THAT(text, HasSubstr("id=\"bone---skin-sabc\""));
    EXPECT_THAT(text, HasSubstr("id=\"bone---skin_hidden\""));
    EXPECT_THAT(text, HasSubstr("stroke-dasharray"));
    EXPECT_THAT(text, HasSubstr("<rect"));
    EXPECT_THAT(svg_of({layers, {640, 480}, std::nullopt}), Not(HasSubstr("<rect")));
}

TEST(Svg, KeepsTheLettersOfAllLanguagesInIds)
{
    const std::string text =
        svg_of({{{"кость 1", {}}, {"череп 1", {}}, {"5° & \u2013", {}}}, {9, 9}});
    EXPECT_THAT(text, HasSubstr("<g id=\"кость-1\""));
    EXPECT_THAT(text, HasSubstr("<g id=\"череп-1\""));
    EXPECT_THAT(text, HasSubstr("<g id=\"5-----\""));
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

TEST(Svg, CarriesDashesOnFromPieceToPiece)
{
    std::vector<InkedLine> lines =
        inked(two_lines(),
              {.color_by = LineColor::hue_by_slope, .taper = 0, .hidden = HiddenLines::dashed});
    std::erase_if(lines, [](const InkedLine& line) { return !line.dashed; });
    ASSERT_EQ(lines.size(), 1u);
    const std::vector<LinePiece> pieces = pieces_of(lines[0]);
    ASSERT_GT(pieces.size(), 10u);
    for (const LinePiece& piece : pieces)
        EXPECT_NEAR(piece.along, double{piece.points.front().at.x}, 1e-4);
    const std::string text = svg_of({{{"a", lines}}, {100, 100}});
    const double dash = dash_of(lines[0]);
    EXPECT_GE(dash, 3 * double{lines[0].points[0].width}) << "longer than wide";
    EXPECT_THAT(text, HasSubstr(fmt::format("stroke-dasharray=\"{0:.2f} {0:.2f}\" "
                                            "stroke-dashoffset=\"{1:.2f}\" stroke-linecap=\"butt\"",
                                            dash, std::fmod(pieces[3].along, 2 * dash))));
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

} // namespace
} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/drawing/hand_edits.h"
#include "core/drawing/svg.h"
#include "tests/drawing/two_lines.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Two layers; the lines of the first one are dashed where they are hidden.
DrawingSheet two_layers(float width = 1.8f)
{
    DrawingSheet out =
        two_line_drawing({.width = width, .taper = 0, .hidden = HiddenLines::dashed});
    out.layers.push_back({"skin", inked(std::vector{two_lines()[0]}, {.taper = 0})});
    return out;
}

// The text of a drawing that is written over another one that a person changed.
std::string written_over(const std::string& earlier, DrawingSheet drawing)
{
    apply(read_hand_edits(earlier), drawing);
    return svg_of(drawing);
}

// The places between the tags of a text, in its root.
std::vector<std::size_t> places_in(const std::string& text)
{
    std::vector<std::size_t> out;
    const std::size_t list = text.find("<desc"), list_end = text.find("</desc>");
    for (std::size_t at = text.find('<', 1); at != text.npos; at = text.find('<', at + 1))
        if (at <= list || at > list_end) out.push_back(at);
    return out;
}

TEST(SvgUpdate, ChangesNoByteOfADrawingThatIsAsItWas)
{
    const std::string text = svg_of(two_layers());
    EXPECT_EQ(written_over(text, two_layers()), text);
}

TEST(SvgUpdate, ChangesNoByteOfALayerThatAPersonDrewAfterTheFirstTime)
{
    std::string text = svg_of(two_layers());
    for (std::size_t at; (at = text.find(" stroke-linecap=\"round\"")) != text.npos;)
        text.erase(at, 23);
    for (std::size_t at; (at = text.find(" fill=\"none\"")) != text.npos;) text.erase(at, 12);
    const std::string once = written_over(text, two_layers(2.5f));
    EXPECT_EQ(written_over(once, two_layers(2.5f)), once);
}

TEST(SvgUpdate, KeepsElementsAtAnyPlaceByteForByte)
{
    const std::string text = svg_of(two_layers());
    for (const std::string own :
         {"<text x=\"3\" y=\"4\">Vena  cava &#38; more</text>", "<!-- mine -->", "<?mine a=1?>",
          "\n  <g\n     id=\"leaders\"\n     sodipodi:insensitive='true'><path d=\"M0 "
          "0\"/></g>\n\t",
          "<style>.a{stroke:red}</style><defs><path id=\"bone---skin-sabc\" d=\"M1 1\"/></defs>",
          "<image xlink:href=\"data:image/png;base64,AAAA\"/>\r\n<metadata><rdf:RDF/></metadata>"})
        for (const std::size_t at : places_in(text)) {
            std::string mine = text;
            mine.insert(at, own);
            EXPECT_EQ(written_over(mine, two_layers()), mine) << at;
        }
}

TEST(SvgUpdate, KeepsThemWhereLinesComeAndGoAndChange)
{
    DrawingSheet fewer = two_layers(3), more = two_layers();
    fewer.layers[0].lines.pop_back();
    fewer.layers.push_back({"new", inked(two_lines(), {.taper = 0})});
    more.layers[0].lines.push_back(more.layers[0].lines[1]);
    more.layers[0].lines.back().id = 0xdef;
    const std::string text = svg_of(two_layers()), own = "<text>mine</text>\n";
    const auto lines_of = [](const std::string& svg) {
        return svg.substr(svg.find("</desc>")); // after the list
    };
    for (const DrawingSheet& next : {fewer, more, two_layers(2.5f)})
        for (const std::size_t at : places_in(text)) {
            std::string mine = text;
            mine.insert(at, own);
            std::string out = written_over(mine, next);
            ASSERT_THAT(out, HasSubstr(own)) << at;
            out.erase(out.find(own), own.size());
            // A group of which no line is left stays where it holds what is a person's.
            if (const std::string bare = "<g id=\"bone---skin_seen\">\n</g>\n";
                out.find(bare) != out.npos)
                out.erase(out.find(bare), bare.size());
            EXPECT_EQ(lines_of(out), lines_of(svg_of(next))) << at;
        }
}

TEST(SvgUpdate, PutsNewLinesAfterThoseBeforeThemAndTakesEmptyLayersAway)
{
    DrawingSheet one = two_layers(), both = two_layers();
    one.layers.erase(one.layers.begin());
    EXPECT_EQ(written_over(svg_of(one), both), svg_of(both));
    both.layers[0].lines[1].id = 0x77; // another line: the old one is gone
    const std::string out = written_over(svg_of(two_layers()), both);
    EXPECT_THAT(out, Not(HasSubstr("<path id=\"bone---skin-sabc\"")));
    EXPECT_THAT(out, HasSubstr("<path id=\"bone---skin-s77\""));
    EXPECT_THAT(written_over(svg_of(two_layers()), {{one.layers}, {640, 480}}),
                Not(HasSubstr("<g id=\"bone---skin\"")));
}

TEST(SvgUpdate, LeavesLinesWhereAPersonPutThem)
{
    const std::string text = svg_of(two_layers());
    const std::size_t at = text.find("<path id=\"bone---skin-sabc\"");
    const std::string line = text.substr(at, text.find('\n', at) + 1 - at);
    std::string moved = text;
    moved.erase(at, line.size());
    moved.insert(moved.find("</svg>"), "<g id=\"mine\">\n" + line + "</g>\n");
    EXPECT_EQ(written_over(moved, two_layers()), moved);
    const std::string wider = written_over(moved, two_layers(3));
    EXPECT_THAT(wider,
                HasSubstr("<g id=\"mine\">\n<path id=\"bone---skin-sabc\" stroke=\"#0d0d12\" "
                          "stroke-width=\"3.00\""));
}

TEST(SvgUpdate, KeepsLinesThatAPersonDoesNotDisplay)
{
    const std::string hidden =
        replaced(svg_of(two_layers()), "<g id=\"skin\"", "<g style=\"display:none\" id=\"skin\"");
    EXPECT_EQ(written_over(hidden, two_layers()).find("\n<g style=\"display:none\" id=\"skin\""),
              hidden.find("\n<g style=\"display:none\" id=\"skin\""));
    const std::string shown = replaced(written_over(hidden, two_layers()), "display:none", "");
    EXPECT_TRUE(read_hand_edits(shown).by_line.empty()) << "they can be shown again";
}

TEST(SvgUpdate, KeepsWhatElseAPersonGaveToALine)
{
    const std::string own = "<path id=\"bone---skin-sabc\"", text = svg_of(two_layers());
    const std::string mine =
        replaced(text, own,
                 "<path\n  style=\"stroke:#ff0000;filter:url(#soft)\" class=\"v\"\n  "
                 "transform=\"scale(2)\" id=\"bone---skin-sabc\"");
    const std::string out = written_over(mine, two_layers(3));
    EXPECT_THAT(out, HasSubstr("<path\n  style=\"stroke:#ff0000;filter:url(#soft)\" class=\"v\" "
                               "id=\"bone---skin-sabc\" stroke=\"#ff0000\" stroke-width=\"3.00\""));
    EXPECT_EQ(written_over(out, two_layers(3)), out);
}

TEST(SvgUpdate, GivesThePageItsSizeAndColorUnlessAPersonDid)
{
    DrawingSheet larger = two_layers();
    larger.size = {800, 600};
    larger.paper = glm::vec3(0);
    const std::string text = svg_of(two_layers());
    EXPECT_EQ(written_over(text, larger), svg_of(larger));
    const std::string page = replaced(text, "viewBox=\"0 0 640 480\"", "viewBox=\"-9 -9 700 500\"");
    EXPECT_THAT(written_over(page, larger), HasSubstr("viewBox=\"-9 -9 700 500\""));
    const std::string tinted = replaced(text, "fill=\"#ffffff\"", "fill=\"#ffeedd\"");
    EXPECT_THAT(written_over(tinted, larger), HasSubstr("fill=\"#ffeedd\""));
    const std::size_t at = text.find("<rect");
    std::string bare = text;
    bare.erase(at, text.find('\n', at) + 1 - at);
    EXPECT_EQ(written_over(bare, two_layers()), bare);
}

// Inkscape saves attributes on lines of their own, its view, edits as styles.
constexpr const char* inkscape_head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
    "<!-- Created with Inkscape (http://www.inkscape.org/) -->\n"
    "<svg\n   width=\"640\"\n   height=\"480\"\n   viewBox=\"0 0 640 480\"\n   version=\"1.1\"\n"
    "   id=\"svg7\"\n   sodipodi:docname=\"bone.svg\"\n"
    "   xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
    "   xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\"\n"
    "   xmlns=\"http://www.w3.org/2000/svg\">\n  <sodipodi:namedview\n     id=\"nv7\"\n"
    "     pagecolor=\"#ffffff\" />\n  <defs\n     id=\"defs7\"><marker\n       id=\"dot\" "
    "/></defs>\n";

// Brings the elements of a drawing into the head of another program's file.
std::string in_head(const std::string& head, const DrawingSheet& drawing)
{
    const std::string text = svg_of(drawing);
    return head + text.substr(text.find("<desc"));
}

TEST(SvgUpdate, GoesIntoAFileOfInkscape)
{
    std::string mine = in_head(inkscape_head, two_layers());
    mine = replaced(mine, "stroke=\"#0d0d12\" stroke-width=\"1.80\"",
                    "style=\"stroke:#008000;stroke-width:4\"\n       stroke=\"#0d0d12\" "
                    "stroke-width=\"1.80\"");
    mine = replaced(
        mine, "</svg>",
        "  <g\n     inkscape:groupmode=\"layer\"\n     id=\"layer1\"\n     "
        "inkscape:label=\"labels\"><text\n       xml:space=\"preserve\"\n       "
        "x=\"10\"><tspan\n         sodipodi:role=\"line\">Atlas</tspan></text></g>\n</svg>");
    const std::string out = written_over(mine, two_layers());
    EXPECT_THAT(out, HasSubstr(inkscape_head));
    EXPECT_THAT(out, HasSubstr(mine.substr(mine.find("  <g\n     inkscape:groupmode"))));
    EXPECT_THAT(out, HasSubstr("style=\"stroke:#008000;stroke-width:4.00\"\n       "
                               "stroke=\"#008000\" stroke-width=\"4.00\""));
    EXPECT_EQ(written_over(out, two_layers()), out);
}

// Illustrator saves entities for namespaces, classes, polylines, none of Inkscape's names.
TEST(SvgUpdate, GoesIntoAFileOfIllustrator)
{
    const DrawingSheet drawing = two_layers();
    const std::string text = svg_of(drawing),
                      list = text.substr(text.find("<desc"),
                                         text.find("</desc>") + 7 - text.find("<desc"));
    const std::string head =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!-- Generator: Adobe Illustrator 27 -->\n"
        "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
        "\"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\" [\n"
        "\t<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n]>\n"
        "<svg version=\"1.1\" xmlns=\"&ns_svg;\" x=\"0px\" y=\"0px\" width=\"640px\" "
        "height=\"480px\" viewBox=\"0 0 640 480\" style=\"enable-background:new 0 0 640 480;\" "
        "xml:space=\"preserve\">\n<style type=\"text/css\">\n"
        "\t.st0{fill:none;stroke:#FF0000;stroke-width:1.8;stroke-linecap:round;}\n"
        "\t.st1{font-family:'MyriadPro-Regular';}\n</style>\n";
    const std::string label = "<g id=\"Labels\">\n\t<text transform=\"matrix(1 0 0 1 9 9)\" "
                              "class=\"st1\">Atlas</text>\n</g>\n";
    const std::string mine = head + list +
                             "\n<g id=\"bone---skin\">\n\t<g id=\"bone---skin_seen\">\n\t\t"
                             "<polyline id=\"bone---skin-sabc\" class=\"st0\" points=\"0,10 99,10 "
                             "\"/>\n\t</g>\n</g>\n" +
                             label + "</svg>\n";
    const HandEdits edits = read_hand_edits(mine);
    EXPECT_EQ(edits.by_line.at("bone---skin-sabc").color, glm::vec3(1, 0, 0));
    EXPECT_FALSE(edits.by_line.at("bone---skin-sabc").deleted);
    EXPECT_TRUE(edits.by_line.at("bone---skin-h12").deleted);
    const std::string out = written_over(mine, drawing);
    EXPECT_THAT(out, HasSubstr(head));
    EXPECT_THAT(out, HasSubstr(label + "</svg>"));
    EXPECT_THAT(out, HasSubstr("<path id=\"bone---skin-sabc\" class=\"st0\" stroke=\"#ff0000\" "
                               "stroke-width=\"1.80\""));
    EXPECT_THAT(out, HasSubstr("99 10\" style=\"stroke:#ff0000;stroke-width:1.80\"/>"));
    EXPECT_THAT(out, Not(HasSubstr("<polyline")));
    EXPECT_THAT(out, Not(HasSubstr("inkscape:"))); // a prefix that the file does not know
    EXPECT_EQ(written_over(out, drawing), out);
}

// Affinity saves all of the look in styles, the page in percent, no namespace of Inkscape.
TEST(SvgUpdate, GoesIntoAFileOfAffinity)
{
    DrawingSheet drawing = two_layers();
    const std::string text = svg_of(drawing),
                      list = text.substr(text.find("<desc"),
                                         text.find("</desc>") + 7 - text.find("<desc"));
    const std::string head =
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n<svg width=\"100%\" "
        "height=\"100%\" viewBox=\"0 0 640 480\" xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:serif=\"http://www.serif.com/\" "
        "style=\"fill-rule:evenodd;stroke-linecap:round;\">\n";
    const std::string label =
        "    <text x=\"9px\" y=\"9px\" style=\"font-size:12px;\">Atlas</text>\n";
    const std::string mine =
        head + list +
        "\n    <g id=\"bone---skin\" serif:id=\"bone &amp; skin\">\n        <g "
        "id=\"bone---skin_seen\">\n            <path id=\"bone---skin-sabc\" "
        "d=\"M0,10L99,10\" style=\"fill:none;stroke:rgb(0,0,255);stroke-width:3.6px;\"/>"
        "\n        </g>\n    </g>\n" +
        label + "</svg>\n";
    const HandEdits::Edit edit = read_hand_edits(mine).by_line.at("bone---skin-sabc");
    EXPECT_EQ(edit.color, glm::vec3(0, 0, 1));
    EXPECT_NEAR(edit.widening, 2, 1e-3);
    drawing.layers[0].lines.push_back(drawing.layers[0].lines[1]);
    drawing.layers[0].lines.back().id = 0xdef;
    const std::string out = written_over(mine, drawing);
    EXPECT_THAT(out, HasSubstr(head));
    EXPECT_THAT(out, HasSubstr(label + "</svg>"));
    EXPECT_THAT(out, HasSubstr("style=\"fill:none;stroke:#0000ff;stroke-width:3.60\""));
    EXPECT_THAT(out,
                HasSubstr("<path id=\"bone---skin-sdef\" fill=\"none\" stroke-linecap=\"round\""))
        << "its group has no style that it could inherit";
}

TEST(SvgUpdate, KnowsLinesByTheirGroupsWhereTheListIsLost)
{
    std::string mine = svg_of(two_layers());
    mine.erase(mine.find("<desc"), mine.find("</desc>") + 8 - mine.find("<desc"));
    mine.insert(mine.find("</svg>"), "<text>mine</text>");
    const std::string out = written_over(mine, two_layers(3));
    EXPECT_THAT(out, HasSubstr("<text>mine</text></svg>"));
    EXPECT_THAT(out, HasSubstr("stroke-width=\"3.00\""));
    EXPECT_EQ(read_hand_edits(out).added, 1u);
    EXPECT_EQ(hand_edits_of("<svg><path id=\"a-s1\"/></svg>"), std::nullopt) << "not drawn here";
}

TEST(SvgUpdate, RefusesWhatIsBrokenOrHostile)
{
    std::string deep = "<svg>";
    for (int i = 0; i < 1001; ++i) deep += "<g>";
    const std::string list = "<desc id=\"trivar-lines\"/>";
    for (const std::string& text :
         {deep, std::string("<svg"), "<svg>" + list, "<svg>" + list + "</g></svg>",
          "<svg>" + list + "</svg><svg/>", "<html>" + list + "</html>",
          "<svg>" + list + "<a b></a></svg>", "<svg>" + list + "<a b='c'\"d='e'/></svg>",
          "<svg>" + list + "<a b='<'/></svg>", "<svg>" + list + "<!-- </svg>",
          "<svg>" + list + "<g><a></g></a></svg>",
          "<!DOCTYPE svg [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]><svg>" + list + "</svg>",
          "<!DOCTYPE svg [<!ENTITY a SYSTEM \"/etc/passwd\">]><svg>" + list + "</svg>",
          std::string("\xff\xfe<\0s\0v\0g\0", 10)})
        EXPECT_THROW(read_hand_edits(text), Rejected) << text.substr(0, 80);
}

} // namespace
} // namespace trivar::testing

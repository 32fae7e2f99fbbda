// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"
#include "core/lines/line_drawing.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<LineWidth>{"even", "slope", "depth",
                                                                         "bend"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<LineColor>{"plain", "slope", "depth",
                                                                         "grey"};
template <>
inline constexpr std::array<std::string_view, 4> choice_words<LineColor>{
    "plain", "hue by slope", "hue by depth", "grey by slope"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<HiddenLines>{"none", "faint",
                                                                           "dashed", "seen"};

template <> struct FieldsOf<LineStyle> {
    static constexpr std::string_view told_as = "[lines](#lines)", about = "How lines are drawn.";
    static void fields(auto& s, auto&& field)
    {
        field("width", s.width, "of the lines, pixels",
              in_range(0.05, 100).called("Line width").in(Unit::pixels));
        field("finest", s.finest, "share of the width down to which a line may become fine",
              in_range(0, 1).called("Finest").in(Unit::share));
        field("width_by", s.width_by,
              "what the width follows: nothing, the slope of the data (steep: fine), the depth "
              "(far: fine), or how sharply the surface turns away (sharp: fine)",
              any_value.called("Width by").without_keys());
        field("color_by", s.color_by,
              "what the colour follows: nothing, the slope or the depth as a hue from red to blue, "
              "or the slope as a grey",
              any_value.called("Colour by").without_keys());
        field("color", s.color, "sRGB red, green, blue",
              in_range(0, 1).called("Line colour").with_axes("red|green|blue"));
        field("taper", s.taper, "length over which a loose end becomes fine, pixels",
              in_range(0, 1000).called("Taper").in(Unit::pixels));
        field("wobble", s.wobble,
              "greatest distance of a line from its place, as of a hand; pixels",
              in_range(0, 100).called("Wobble").in(Unit::pixels).zero_is("none"));
        field("pencil", s.pencil,
              "how far a line is like a pencil's: drawn three times, of uneven width",
              in_range(0, 1).called("Pencil").in(Unit::share).zero_is("none"));
        field("fan_step", s.fan_step,
              "pixels between the fans that tell how the data fall off outside a line",
              in_range(0, 1000).called("Fans every").in(Unit::pixels).zero_is("none"));
        field("fan_length", s.fan_length, "of the longest hairs of a fan, pixels",
              in_range(0.1, 1000).called("Fan length").in(Unit::pixels));
        field("seed", s.seed, "of the wobble and the pencil",
              any_value.called("Seed").without_keys().names_nothing("a seed"));
        field("hidden_lines", s.hidden, "how hidden lines are drawn",
              any_value.called("Hidden lines").without_keys());
    }
};
template <> struct FieldsOf<MoreLines> {
    static constexpr std::string_view told_as = "[further lines](#further-lines)",
                                      about = "Lines of a surface besides its outlines.";
    static void fields(auto& m, auto&& field)
    {
        field("suggestive", m.suggestive,
              "suggestive contours: where an outline would appear from a view nearby",
              any_value.called("Suggestive lines").says("drawn", "off"));
        field("ridges", m.ridges, "where the surface is bent most outward",
              any_value.called("Ridges").says("drawn", "off"));
        field("valleys", m.valleys, "where the surface is bent most inward",
              any_value.called("Valleys").says("drawn", "off"));
        field("parabolic", m.parabolic,
              "between what is bent like a ball and what is bent like a saddle",
              any_value.called("Parabolic lines").says("drawn", "off"));
        field("isophotes", m.isophotes,
              "number of lines of equal light, from where the light grazes on",
              in_range(0, 64).called("Isophotes").zero_is("none").without_keys());
        field("light", m.light, "direction toward the light of isophotes, in the object's space",
              in_range(-1e6, 1e6).called("Light"));
        field("smoothing", m.smoothing,
              "how far the surface is smoothed to find these lines; sides of voxels or triangles",
              in_range(0, 5).called("Smoothing").zero_is("none"));
        field("detail", m.detail, "2: lines half as distinct are drawn, too",
              in_range(0.05, 20).called("Detail"));
        field("share", m.width, "width of these lines as a share of that of outlines",
              in_range(0.01, 10).called("Width of further lines").in(Unit::share));
        field("amount", m.amount,
              "share of the length of all lines that is drawn, outlines too: those that tell most",
              in_range(0, 1).called("Amount of lines").in(Unit::share));
    }
};
template <> struct FieldsOf<LineDrawing> {
    static constexpr std::string_view told_as = "values of [set_line_drawing](#set_line_drawing)";
    static void fields(auto& d, auto&& field)
    {
        field("outlines", d.outlines, "lines where the surface turns away from sight",
              any_value.called("Outlines").says("drawn", "off"));
        field("creases", d.creases, "sharp edges",
              any_value.called("Sharp edges").says("drawn", "off"));
        field("crease_deg", d.crease_deg, "angle between faces from which on an edge is sharp",
              in_range(0, 180).called("Sharp from").in(Unit::degrees));
        field("borders", d.borders, "edges with a face on one side only",
              any_value.called("Borders").says("drawn", "off"));
        field("intersections", d.intersections,
              "lines where its surface goes through those of others, and through itself",
              later.called("Intersections").says("drawn", "off"));
        field("surface", d.surface,
              "whether the surface is shown, too; if not it hides no lines of others",
              any_value.called("Surface").says("shown", "off"));
        field("paper", d.paper, "the surface is plain paper, without light and shade",
              any_value.called("Paper").says("plain", "off"));
        field("paper_color", d.paper_color, "sRGB red, green, blue",
              in_range(0, 1).called("Paper colour").with_axes("red|green|blue"));
        field("ink", d.ink, "how the lines are drawn");
        field("more", d.more, "further lines");
    }
};

} // namespace trivar

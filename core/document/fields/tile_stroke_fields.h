// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 12> choice_names<TileBrush>{
    "scatter", "line", "fill",   "erase", "comb",  "resize",
    "raise",   "grab", "strand", "color", "morph", "adjust"};
template <>
inline constexpr std::array<std::string_view, 6> choice_names<TileHeading>{
    "along_stroke", "upward", "random", "least_curvature", "most_curvature", "to_point"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<TileArea>{"island", "material",
                                                                        "faces", "all"};
template <>
inline constexpr std::array<std::string_view, 4> choice_names<TileMirror>{"none", "x", "y", "z"};

template <> struct FieldsOf<TileSample> {
    static constexpr std::string_view told_as = "[tile sample](#tile-sample)",
                                      about = "A point of such a stroke.";
    static void fields(auto& s, auto&& field)
    {
        field("p", s.at.p, "a point of the base's model at rest, metres",
              required.in(Unit::metres));
        field("normal", s.at.normal, "the normal there", required);
        field("time_s", s.time_s, "seconds since the stroke began", not_negative.in(Unit::seconds));
        field("pressure", s.pressure, "factor of the size of new tiles, or of the strength",
              in_range(0, 1));
    }
};
template <> struct FieldsOf<TileStroke> {
    static constexpr std::string_view told_as = "[tile stroke](#tile-stroke)",
                                      about = "A stroke with which tiles were painted.";
    static void fields(auto& s, auto&& field)
    {
        field(
            "brush", s.brush,
            "scatter, line and fill lay tiles; strand lays them end to end; erase, comb, resize, "
            "raise, color and morph change "
            "those under the brush; grab and adjust take single tiles, one for each sample, which "
            "is within half of its size: adjust turns, scales or removes them, and grab moves "
            "them, so that the first one goes to the last sample");
        field("samples", s.samples, "the points of the stroke", required);
        field("radius", s.radius, "of the brush, metres on the model",
              positive.called("Brush radius").in(Unit::metres));
        field("size", s.size, "side of a new tile, metres on the model", positive.in(Unit::metres));
        field("spacing", s.spacing, "least distance between tiles, in sizes",
              in_range(0.05, 100).in(Unit::times));
        field("height", s.height, "factor of the height of new tiles",
              in_range(0, 100).in(Unit::times));
        field("size_variation", s.size_variation, "sizes are smaller by up to this share",
              in_range(0, 1).in(Unit::share));
        field("turn_variation_deg", s.turn_variation_deg,
              "new tiles are turned by up to this angle either way, degrees",
              in_range(0, 180).called("Turn variation").in(Unit::degrees));
        field("heading", s.heading,
              "where the x axis of a new tile points: along the stroke, up, anywhere, where the "
              "surface bends least or most, or to a point");
        field("strength", s.strength,
              "of comb, resize, raise, color and morph; negative: smaller, lower or back",
              in_range(-1, 1).in(Unit::share));
        field("seed", s.seed, "of the random numbers", in_range(0, 1e9));
        field("hidden", s.hidden, "it does nothing", any_value.called("Stroke").says("off", "on"));
        field("width", s.width, "of a strand: factor of the width of its tiles",
              later_in_range(0.01, 100).resting_at(1).in(Unit::times));
        field("taper", s.taper, "of a strand: share by which it is narrower and lower at its end",
              later_in_range(0, 1).in(Unit::share));
        field("apart", s.apart,
              "the ends of a strand do not join with those of others near them, or each other",
              later.called("Ends").says("apart", "joined"));
        field("point", s.point, "that tiles head to, on the base's model at rest, metres",
              later.in(Unit::metres));
        field("area", s.area,
              "what is filled: all that is connected with what the stroke touches, all of that "
              "material, the faces that it touches, or the whole base",
              later);
        field("mirror", s.mirror,
              "the stroke works on the other side of this plane through the origin of the base's "
              "model, too: that across X, Y or Z",
              later);
        field("mirrors_tiles", s.mirrors_tiles,
              "tiles beyond that plane are mirror images, too, as a left feather is of a right "
              "one; those of strands are not",
              later.called("Mirror tiles"));
        field("color", s.color,
              "linear red, green and blue by which the brush color multiplies those of materials",
              later_in_range(0, 1).resting_at(1).called("Colour").with_axes("red|green|blue"));
        field("turn_deg", s.turn_deg, "by which adjusted tiles are turned, degrees",
              later_in_range(-36000, 36000).called("Turn").in(Unit::degrees));
        field("factor", s.factor, "of the sizes of adjusted tiles; 0 removes them",
              later_in_range(0, 100).resting_at(1).in(Unit::times));
    }
};

} // namespace trivar

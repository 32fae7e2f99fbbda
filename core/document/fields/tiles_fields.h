// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/mask_fields.h"
#include "core/document/fields/mix_fields.h"
#include "core/document/fields/tile_cover_fields.h"
#include "core/document/fields/tile_look_fields.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 9> choice_names<TileBrush>{
    "scatter", "line", "fill", "erase", "comb", "resize", "raise", "grab", "strand"};
template <>
inline constexpr std::array<std::string_view, 3> choice_names<TileHeading>{"along_stroke", "upward",
                                                                           "random"};

template <> struct FieldsOf<TileSample> {
    static constexpr std::string_view told_as = "[tile sample](#tile-sample)";
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
    static constexpr std::string_view told_as = "[tile stroke](#tile-stroke)";
    static void fields(auto& s, auto&& field)
    {
        field("brush", s.brush,
              "scatter, line and fill lay tiles; strand lays them end to end; erase, comb, resize "
              "and raise change those under the brush; grab moves the one nearest to the first "
              "sample to the last sample");
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
        field("heading", s.heading, "where the x axis of a new tile points");
        field("strength", s.strength, "of comb, resize and raise; negative: smaller or lower",
              in_range(-1, 1));
        field("seed", s.seed, "of the random numbers", in_range(0, 1e9));
        field("hidden", s.hidden, "it does nothing", any_value.called("Stroke").says("off", "on"));
        field("width", s.width, "of a strand: factor of the width of its tiles",
              later_in_range(0.01, 100).resting_at(1).in(Unit::times));
        field("taper", s.taper, "of a strand: share by which it is narrower and lower at its end",
              later_in_range(0, 1).in(Unit::share));
        field("apart", s.apart,
              "the ends of a strand do not join with those of others near them, or each other",
              later.called("Ends").says("apart", "joined"));
    }
};
template <> struct FieldsOf<Tiling> {
    static void fields(auto& t, auto&& field)
    {
        field("base", t.base, "id of what it is painted on", any_value.without_keys());
        field("look", t.look, "what holds for all tiles", any_value.as_its_own());
        field("strokes", t.strokes, "the strokes, the first one first", any_value.without_keys());
        field("weight", t.weight, "how often the object itself is there, in a mix of several",
              later_in_range(0, 1000).resting_at(1).without_keys());
        field("others", t.others, "the other objects among the tiles", later.without_keys());
        field("into", t.into, "id of what its own tiles become by the morph; 0: nothing",
              later.without_keys());
        field("cover", t.cover, "how they cover all of it", later);
        field("masks", t.masks, "where there are more of them, larger or higher ones",
              later.called("Mask"));
    }
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/tile_stroke_fields.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<TilePattern>{"none", "grid", "brick",
                                                                           "hexagon"};

template <> struct FieldsOf<TileLook> {
    static constexpr std::string_view told_as = "values of [set_tiles](#set_tiles)";
    static void fields(auto& l, auto&& field)
    {
        field("scale", l.scale, "factor of the sizes of all tiles",
              in_range(1e-3, 100).in(Unit::times));
        field("height", l.height, "factor of the heights of all tiles",
              in_range(0, 100).in(Unit::times));
        field("sink", l.sink, "how deep tiles stand in their base, as a share of their height",
              in_range(-10, 10).in(Unit::share));
        field("turn_deg", l.turn_deg, "of all tiles about their normals, degrees",
              in_range(-36000, 36000).called("Turn").in(Unit::degrees));
        field("guard", l.guard, "tiles that would fold are lowered until they do not",
              any_value.called("Folds").says("prevented", "allowed"));
        field("growth", l.growth, "share of the painting that has grown, in the order of painting",
              later_in_range(0, 1).resting_at(1).in(Unit::share));
        field("growth_softness", l.growth_softness,
              "share of the painting in which a tile grows to its full size",
              later_in_range(0, 1).resting_at(0.1).called("Softness").in(Unit::share));
        field("wave", l.wave, "by how much heights go up and down, as a share of them",
              later_in_range(0, 10).in(Unit::share));
        field("wave_phase", l.wave_phase, "turns of the wave; keys on it let the wave run",
              later_in_range(-1e6, 1e6));
        field("wave_length", l.wave_length,
              "length of the wave, metres on the model; 0: all tiles move at once",
              later_in_range(0, 1e9).in(Unit::metres));
        field("wave_direction", l.wave_direction,
              "where the wave goes to, in the model's space; 0: along Z", later);
        field("wave_variation", l.wave_variation,
              "turns by which the phases of tiles differ at random", later_in_range(0, 1));
        field("morph", l.morph,
              "how far tiles have become the other shape: 0 not yet, 1 altogether; may go beyond",
              later_in_range(-10, 10));
        field("morph_variation", l.morph_variation,
              "share of the morph by which the last tiles are behind the first",
              later_in_range(0, 1).in(Unit::share));
        field("clip_variation", l.clip_variation,
              "share of the clip by which tiles are ahead of each other at random",
              later_in_range(0, 1).in(Unit::share));
        field("phases", l.phases, "in how many different phases of clip and morph tiles are",
              later_in_range(1, 64).resting_at(8).without_keys());
        field("slide_x", l.slide_x, "how far tiles have gone along their own X, in sides",
              later_in_range(-1000, 1000).called("Slide X"));
        field("slide_y", l.slide_y, "how far tiles have gone along their own Y, in sides",
              later_in_range(-1000, 1000).called("Slide Y"));
        field("overlaps", l.overlaps,
              "painted tiles that overlap earlier ones by more than a tenth of their side stay",
              later.resting_at(1).says("kept", "left out").without_keys());
    }
};
template <> struct FieldsOf<MixedTile> {
    static constexpr std::string_view
        told_as = "[mixed tile](#mixed-tile)",
        weight_help = "how often it is there, beside the weights of the others",
        besides_help = "with what the layer is mixed from now on, besides; they are hidden";
    static void fields(auto& m, auto&& field)
    {
        field("object", m.object, "id of an object", required);
        field("weight", m.weight, weight_help, in_range(0, 1000));
    }
};
template <> struct FieldsOf<TileCover> {
    static constexpr std::string_view told_as = "[tile cover](#tile-cover)";
    static void fields(auto& c, auto&& field)
    {
        field("pattern", c.pattern,
              "how tiles cover all of the base: in rows; in rows of which every other one is "
              "shifted by half a tile; the same with hexagons that reach into the rows beside "
              "theirs; or not",
              any_value.without_keys());
        field("size", c.size, "length of a tile along its row, metres on the model",
              positive.in(Unit::metres).without_keys());
        field("per_face", c.per_face,
              "number of tiles along each side of a face; 0: as the size says",
              in_range(0, 1000).zero_is("by size").without_keys());
        field("height_variation", c.height_variation,
              "heights are smaller by up to this share, at random", in_range(0, 1).in(Unit::share));
        field("seed", c.seed, "of the random numbers", in_range(0, 1e9).without_keys());
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
    }
};

} // namespace trivar

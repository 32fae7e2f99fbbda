// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<TilePattern>{"none", "grid", "brick",
                                                                           "hexagon"};

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

} // namespace trivar

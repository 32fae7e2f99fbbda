// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 5> choice_names<TilePattern>{"none", "grid", "brick",
                                                                           "hexagon", "texture"};

template <> struct FieldsOf<TileCover> {
    static constexpr std::string_view told_as = "[tile cover](#tile-cover)",
                                      about = "How tiles cover a whole surface.";
    static void fields(auto& c, auto&& field)
    {
        field("pattern", c.pattern,
              "how tiles cover all of the base: in rows; in rows of which every other one is "
              "shifted by half a tile; the same with hexagons that reach into the rows beside "
              "theirs; one for each cell of the texture square; or not",
              any_value.without_keys());
        field("size", c.size, "length of a tile along its row, metres on the model",
              positive.in(Unit::metres).without_keys());
        field("per_face", c.per_face,
              "number of tiles along each side of a face; 0: as the size says",
              in_range(0, 1000).zero_is("by size").without_keys());
        field("height_variation", c.height_variation,
              "heights are smaller by up to this share, at random", in_range(0, 1).in(Unit::share));
        field("seed", c.seed, "of the random numbers", in_range(0, 1e9).without_keys());
        field("even_height", c.even_height,
              "tiles are as high as their object everywhere, and not in proportion to their length",
              later.without_keys().called("Height of tiles").says("the object's own", "by length"));
        field("columns", c.columns, "number of cells along u, with the pattern texture",
              later_in_range(1, 2000).resting_at(20).without_keys());
        field("rows", c.rows, "number of cells along v, with the pattern texture",
              later_in_range(1, 2000).resting_at(20).without_keys());
    }
};

} // namespace trivar

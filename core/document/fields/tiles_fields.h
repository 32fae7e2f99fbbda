// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/mask_fields.h"
#include "core/document/fields/mix_fields.h"
#include "core/document/fields/tile_cover_fields.h"
#include "core/document/fields/tile_look_fields.h"
#include "core/document/fields/tile_stroke_fields.h"

namespace trivar {

template <> struct FieldsOf<Tiling> {
    static constexpr std::string_view copied_as = "[tiling](#tiling)";
    static void fields(auto& t, auto&& field)
    {
        field("base", t.base,
              "id of what it is painted on: in a copy another copy, or an object of the scene",
              any_value.without_keys().names_object("painted on"));
        field("look", t.look, "what holds for all tiles", any_value.as_its_own());
        field("strokes", t.strokes, "the strokes, the first one first", any_value.without_keys());
        field("weight", t.weight, "how often the object itself is there, in a mix of several",
              later_in_range(0, 1000).resting_at(1).without_keys());
        field("others", t.others, "the other objects among the tiles", later.without_keys());
        field("into", t.into, "id of what its own tiles become by the morph; 0: nothing",
              later.without_keys().names_object("turned into"));
        field("cover", t.cover, "how they cover all of it", later);
        field("masks", t.masks, "where there are more of them, larger or higher ones",
              later.called("Mask"));
    }
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<MixedTile> {
    static constexpr std::string_view
        told_as = "[mixed tile](#mixed-tile)",
        about = "An object among the tiles of a layer.",
        copied_as = "[copied mixed tile](#copied-mixed-tile)",
        weight_help = "how often it is there, beside the weights of the others",
        besides_help = "with what the layer is mixed from now on, besides; they are hidden";
    static void fields(auto& m, auto&& field)
    {
        field("object", m.object, "id of an object",
              required.names_object("mixed with").copied_as("tile"));
        field("weight", m.weight, weight_help, in_range(0, 1000));
    }
};

} // namespace trivar

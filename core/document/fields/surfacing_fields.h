// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Surfacing> {
    static constexpr std::string_view told_as = "values of [set_material](#set_material)";
    static void fields(auto& s, auto&& field)
    {
        field("base_color", s.base_color, "linear red, green, blue and opacity",
              in_range(0, 1).called("Colour").with_axes("red|green|blue|opacity"));
        field("metallic", s.metallic, "0: not a metal, 1: a metal", in_range(0, 1));
        field("roughness", s.roughness, "0: a mirror, 1: chalk", in_range(0, 1));
        field("solid", s.filling,
              "solid texture that deforms with the object; the colour tints it, and it has its own "
              "roughness",
              any_value.counts(Counting::bare).called("Solid texture"));
        field("glow", s.glow,
              "light that it gives off by itself, its colour times this; others are not lit by it",
              later_in_range(0, 1000).called("Glow").zero_is("none"));
    }
};

} // namespace trivar

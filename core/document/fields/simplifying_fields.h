// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Simplifying> {
    static constexpr std::string_view told_as = "values of [simplify](#simplify)";
    static void fields(auto& s, auto&& field)
    {
        field("keep", s.keep,
              "share of the triangles that stays, as far as the deviation allows; borders, creases "
              "and seams stay",
              in_range(1e-4, 1).in(Unit::share));
        field("deviation", s.deviation,
              "metres that the surface may be off at most, before the object is placed or scaled; "
              "0: no limit",
              not_negative.in(Unit::metres).zero_is("any"));
    }
};

} // namespace trivar

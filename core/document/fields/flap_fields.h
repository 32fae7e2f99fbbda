// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 2> choice_names<IncisionSide>{"left", "right"};

template <> struct FieldsOf<PeeledFlap> {
    static constexpr std::string_view told_as = "values of [peel_flap](#peel_flap)";
    static void fields(auto& f, auto&& field)
    {
        field("first", f.first, "number of one of the two incisions between which it lies",
              required_in_range(1, 64).without_keys());
        field("second", f.second, "number of the other one",
              required_in_range(1, 64).without_keys());
        field("side_of_first", f.side_of_first,
              "on which side of the first one it lies, seen along its stroke from outside",
              any_value.without_keys());
        field("side_of_second", f.side_of_second, "on which side of the second one it lies",
              any_value.without_keys());
        field("lift", f.lift,
              "height of its raised tip while both incisions are open, metres on the model",
              not_negative.called("Peeled").in(Unit::metres));
    }
};

} // namespace trivar

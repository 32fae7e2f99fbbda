// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 2> choice_names<UnwrapMethod>{"conformal", "rigid"};
template <>
inline constexpr std::array<std::string_view, 2> choice_words<UnwrapMethod>{"angles", "lengths"};

template <> struct FieldsOf<Unwrapping> {
    static constexpr std::string_view told_as = "values of [unwrap](#unwrap)";
    static void fields(auto& u, auto&& field)
    {
        field("method", u.method,
              "what is kept where the surface is laid flat: its angles, or its lengths as well as "
              "that can be",
              any_value.called("Keeps"));
        field("seam_angle_deg", u.seam_angle_deg,
              "degrees; charts end at edges over which faces turn by more",
              in_range(0, 180).called("Seam angle").in(Unit::degrees));
        field("spread_deg", u.spread_deg,
              "degrees by which the surface may lean away from the middle of a chart: less makes "
              "more charts of less stretch",
              in_range(1, 120).called("Spread").in(Unit::degrees));
        field("margin", u.margin,
              "free round each chart, as a share of the square; less where there are many charts",
              in_range(0, 0.1).in(Unit::share));
    }
};

} // namespace trivar

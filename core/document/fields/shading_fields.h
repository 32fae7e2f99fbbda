// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<ShadingWay>{"own", "smooth",
                                                                          "by_angle", "flat"};

template <> struct FieldsOf<FaceShading> {
    static constexpr std::string_view told_as = "values of [shade](#shade)";
    static void fields(auto& s, auto&& field)
    {
        field("way", s.way,
              "own: as its file has it; by_angle: smooth, with edges where faces meet at more than "
              "the angle",
              any_value.called("Shade"));
        field("angle_deg", s.angle_deg,
              "degrees; faces that meet at more have an edge between them",
              in_range(0, 180).called("Edge angle").in(Unit::degrees));
    }
};

} // namespace trivar

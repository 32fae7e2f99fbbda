// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/inside_field.h"
#include "core/split/cutting.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 3> choice_names<CutKeep>{"both", "above", "below"};
template <>
inline constexpr std::array<std::string_view, 3> choice_words<CutKeep>{
    "both parts", "the part above", "the part below"};

template <> struct FieldsOf<PlainCut> {
    static constexpr std::string_view told_as = "[plain cut](#plain-cut)",
                                      about = "A plane or a stroke that cuts an object in two.";
    static void fields(auto& c, auto&& field)
    {
        field("point", c.point, "of the plane, in the object's own space",
              any_value.called("Point").in(Unit::metres));
        field("normal", c.normal, "of the plane there; what it points to is above",
              any_value.called("Normal"));
        field("stroke", c.stroke,
              "points that a smooth curve over the plane goes through, each [way along, height "
              "over the plane], ways ascending; empty: the plane cuts",
              any_value.without_keys());
        field("along", c.along, "direction of those ways", any_value.without_keys());
        field("eye", c.eye,
              "how far before the point the eye was, from which lines sweep the curve; 0: parallel "
              "lines do",
              not_negative.without_keys());
        field("keep", c.keep, "what stays: both parts, the part above or the part below",
              any_value.called("Keep"));
        field("gap", c.gap, "metres between the halves, each of which moves by half of it",
              any_value.called("Gap").in(Unit::metres));
        field("opened", c.opened,
              "how far the part above each earlier cut stood off its place when this one was drawn "
              "over it, in the object's own space; the part below stood off as far the other way",
              later.without_keys());
        field("parted", c.parted,
              "it cuts what obstacles leave of the object, as it was drawn over that",
              later.without_keys());
    }
};

template <> struct FieldsOf<Cutting> {
    static constexpr std::string_view told_as = "values of [cut](#cut)";
    static void fields(auto& c, auto&& field)
    {
        field("cuts", c.cuts, "planes and strokes that cut, one after the other", required);
        field("capped", c.capped, "the pieces are closed, so that they stay solid",
              any_value.called("Closed"));
        inside_field(c.inside, field);
        field("tolerance", c.tolerance,
              "metres; triangles are split until a curved cut is nowhere further from its stroke",
              in_range(1e-12, 1e9).called("Tolerance").in(Unit::metres));
    }
};

} // namespace trivar

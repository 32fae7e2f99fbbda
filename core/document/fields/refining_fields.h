// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <>
inline constexpr std::array<std::string_view, 4> choice_names<SplitPoint>{
    "equidistributed", "midpoint", "greville", "greatest_error"};

template <>
inline constexpr std::array<std::string_view, 3> choice_names<RefinementRule>{
    "edge_driven", "thesis_four_split", "chua_neumann_midpoint"};

template <>
inline constexpr std::array<std::string_view, 10> choice_names<BoundMethod>{
    "thesis_right_angled",
    "thesis",
    "thesis_circumradius",
    "barycentric",
    "best_corner",
    "circumradius",
    "waldron",
    "net_affine",
    "composed_net",
    "composed_net_subdivided"};

template <> struct FieldsOf<Refining> {
    static constexpr std::string_view told_as = "values of [refine](#refine)";
    static void fields(auto& r, auto&& field)
    {
        field("tolerance", r.tolerance,
              "metres that deformed flat triangles may be from the true surface",
              positive.in(Unit::metres));
        field("split", r.split, "where on an edge");
        field("rule", r.rule,
              "which edges: the second is the thesis's, the third certifies nothing; both are for "
              "comparison");
        field("method", r.method,
              "how the error is bounded; docs/refinement.md names what is false");
        field("budget", r.budget, "triangles at most; what is over the tolerance then is said",
              in_range(12, 20000000));
    }
};

} // namespace trivar

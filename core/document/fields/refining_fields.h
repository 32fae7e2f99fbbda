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
              "metres that flat triangles may be from the true surface at most",
              positive.in(Unit::metres));
        field("split", r.split, "where an edge is split");
        field("rule", r.rule,
              "which edges are split; thesis_four_split and chua_neumann_midpoint are for "
              "comparison, and the latter certifies nothing");
        field("method", r.method,
              "how the error is bounded; docs/refinement.md says which bounds are wrong");
        field("budget", r.budget,
              "the largest number of triangles; a notice says what is then above the tolerance",
              in_range(12, 20000000));
    }
};

} // namespace trivar

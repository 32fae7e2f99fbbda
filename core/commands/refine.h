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
    static void fields(auto& r, auto&& field)
    {
        field("tolerance", r.tolerance,
              "metres that deformed flat triangles may be from the true surface", positive);
        field("split", r.split, "where on an edge");
        field("rule", r.rule,
              "which edges: the second is the thesis's, the third certifies nothing; both are for "
              "comparison");
        field("method", r.method,
              "how the error is bounded; docs/refinement.md names what is false");
        field("budget", r.budget, "triangles at most; what is over the tolerance then is said",
              between(12, 20000000));
    }
};
struct Refine {
    static constexpr std::string_view verb = "refine",
                                      summary = "Split the triangles of placed objects until the "
                                                "bent surface is certified within a tolerance.";
    std::vector<Id> objects;
    Refining refining;
    std::vector<Refining> refinings = {};
    bool operator==(const Refine&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of placed objects", required);
        FieldsOf<Refining>::fields(c.refining, field);
        field("refinings", c.refinings,
              "one each, in the order of the objects, in place of these fields; empty: the same "
              "for all");
    }
};
struct ClearRefine {
    static constexpr std::string_view verb = "clear_refine",
                                      summary = "Give objects the triangles back that they have.";
    std::vector<Id> objects;
    bool operator==(const ClearRefine&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of refined objects", required);
    }
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/shaping_fields.h"
#include "core/tetrahedra/simplex_sheet.h"

namespace trivar {

template <> struct FieldsOf<SheetLift> {
    static constexpr std::string_view told_as = "[lift](#lift)";
    static void fields(auto& l, auto&& field)
    {
        field("at", l.at, "the middle of a circle of control points, at rest",
              required.called("Middle").in(Unit::metres));
        field("radius", l.radius, "of the circle, metres",
              positive.called("Radius").in(Unit::metres));
        field("by", l.by, "metres by which its middle moves",
              required.called("Move").in(Unit::metres));
        field("decay", l.decay, "how it fades from the middle to the rim",
              any_value.called("Fading"));
    }
};
template <> struct FieldsOf<SimplexSheetShape> {
    static constexpr std::string_view verb = "add_simplex_sheet",
                                      summary = "Add a surface of simplex splines over triangles.",
                                      name = "Simplex sheet";
    static void fields(auto& s, auto&& field)
    {
        field("size", s.size, "along X and Y, metres", positive.in(Unit::metres));
        field("boxes", s.boxes, "along X and Y, of two triangles each",
              in_range(1, 100).called("Boxes"));
        field("degree", s.degree, "of the splines: 1 linear, 2 quadratic, 3 cubic",
              in_range(1, 3).called("Degree"));
        field("spread", s.spread,
              "distance of knots from their vertex, as a share of its shortest edge",
              in_range(0.01, 0.3).called("Spread").in(Unit::share));
        field("clamped", s.clamped, "whether control points lie on the border",
              any_value.called("Clamped"));
        field("segments", s.segments, "of the mesh, along each side",
              in_range(1, 1000).called("Segments"));
        field("lifts", s.lifts, "control points moved, one circle after the other");
    }
};

} // namespace trivar

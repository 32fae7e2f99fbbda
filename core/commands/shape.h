// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/shaping_fields.h"

namespace trivar {

struct PressVolume {
    static constexpr std::string_view verb = "press",
                                      summary = "Press a ball into the volume of a placed object, "
                                                "or draw it out.";
    Id object = 0;
    Press press;
    bool operator==(const PressVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
        FieldsOf<Press>::fields(c.press, field);
    }
};
struct MovePoints {
    static constexpr std::string_view verb = "move_points",
                                      summary = "Move control points of the volume of a placed "
                                                "object.";
    Id object = 0;
    PointShift shift;
    bool operator==(const MovePoints&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
        FieldsOf<PointShift>::fields(c.shift, field);
    }
};
struct InsertKnots {
    static constexpr std::string_view verb = "insert_knots",
                                      summary = "Give the volume of a placed object more control "
                                                "points where they are wanted; it keeps its shape.";
    Id object = 0;
    KnotInsertion insertion;
    bool operator==(const InsertKnots&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
        FieldsOf<KnotInsertion>::fields(c.insertion, field);
    }
};
struct CoarsenVolume {
    static constexpr std::string_view verb = "coarsen_volume",
                                      summary = "Leave the volume of a placed object fewer control "
                                                "points, as near to its shape as they come.";
    Id object = 0;
    Coarsening coarsening;
    bool operator==(const CoarsenVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
        FieldsOf<Coarsening>::fields(c.coarsening, field);
    }
};
struct MendVolume {
    static constexpr std::string_view verb = "mend_volume",
                                      summary = "Change the volume of a placed object as little as "
                                                "it takes for nothing to fold.";
    Id object = 0;
    bool operator==(const MendVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
    }
};
struct AllowFolds {
    static constexpr std::string_view verb = "allow_folds",
                                      summary = "Let the volume of a placed object fold in parts "
                                                "of it, which the guard then leaves alone.";
    Id object = 0;
    FoldAllowance allowance;
    bool operator==(const AllowFolds&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
        FieldsOf<FoldAllowance>::fields(c.allowance, field);
    }
};
struct WarpVolume {
    static constexpr std::string_view verb = "warp_volume",
                                      summary = "Twist, bend, taper, shear or bulge a lattice as "
                                                "a whole.";
    Id object = 0;
    Warp warp;
    bool operator==(const WarpVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required);
        FieldsOf<Warp>::fields(c.warp, field);
    }
};
struct Unshape {
    static constexpr std::string_view verb = "unshape",
                                      summary = "Take steps back that shaped the volume of a "
                                                "placed object.";
    Id object = 0;
    std::vector<int> steps;
    bool operator==(const Unshape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required);
        field("steps", c.steps, "which of them, the first is 1; empty: all", between(1, 1e6));
    }
};

} // namespace trivar

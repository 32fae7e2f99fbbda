// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/shaping_fields.h"

namespace trivar {

// Throws Rejected for values that no step of shaping can have, in any volume.
void check(const VolumeEdit& edit);
// The largest number of steps of shaping of one object. A person makes a few hundred; every step is
// done again when the stroke changes.
inline constexpr std::size_t most_shaping_steps = 4096;

// The document with one more step of shaping, also one that the volume cannot take: evaluation
// passes it over and says so. Throws Rejected where the object has no volume or too many steps.
Document with_step(Document document, Id id, VolumeEdit edit);

struct PressVolume {
    static constexpr std::string_view
        verb = "press",
        summary = "Push or pull the volume of a placed object with a soft ball.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    Press press;
    bool operator==(const PressVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        spread(c.press, field);
    }
};
Document applied(Document document, const PressVolume& command);
StepTitle title(const PressVolume& c, const StepDocuments& step);

struct MovePoints {
    static constexpr std::string_view verb = "move_points",
                                      summary = "Move control points of the volume of a placed "
                                                "object.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    PointShift shift;
    bool operator==(const MovePoints&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        spread(c.shift, field);
    }
};
Document applied(Document document, const MovePoints& command);
// Throws Rejected if the object is a lattice that lacks one of the points; see check_new().
void check_effect(const Document& document, const MovePoints& command);
StepTitle title(const MovePoints& c, const StepDocuments& step);

struct InsertKnots {
    static constexpr std::string_view
        verb = "insert_knots",
        summary = "Add control points to the volume of a placed object; it keeps its shape.";
    Id object = 0;
    KnotInsertion insertion;
    bool operator==(const InsertKnots&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        spread(c.insertion, field);
    }
};
Document applied(Document document, const InsertKnots& command);
// Throws Rejected if the object is a lattice that would get too many points; see check_new().
void check_effect(const Document& document, const InsertKnots& command);
StepTitle title(const InsertKnots& c, const StepDocuments& step);

struct CoarsenVolume {
    static constexpr std::string_view verb = "coarsen_volume",
                                      summary = "Remove control points of the volume of a placed "
                                                "object; its shape changes as little as possible.";
    Id object = 0;
    Coarsening coarsening;
    bool operator==(const CoarsenVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        spread(c.coarsening, field);
    }
};
Document applied(Document document, const CoarsenVolume& command);
// Throws Rejected if the object is a lattice that has no such point to remove; see check_new().
void check_effect(const Document& document, const CoarsenVolume& command);
StepTitle title(const CoarsenVolume& c, const StepDocuments& step);

struct MendVolume {
    static constexpr std::string_view
        verb = "mend_volume",
        summary =
            "Repair the folds in the volume of a placed object with as little change as possible.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    bool operator==(const MendVolume&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
    }
};
Document applied(Document document, const MendVolume& command);
StepTitle title(const MendVolume& c, const StepDocuments& step);

struct AllowFolds {
    static constexpr std::string_view
        verb = "allow_folds",
        summary =
            "Allow folds in parts of the volume of a placed object, which the guard then ignores.";
    Id object = 0;
    FoldAllowance allowance;
    bool operator==(const AllowFolds&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        spread(c.allowance, field);
    }
};
Document applied(Document document, const AllowFolds& command);
StepTitle title(const AllowFolds& c, const StepDocuments& step);

struct Unshape {
    static constexpr std::string_view verb = "unshape",
                                      summary = "Undo lattice edits of a placed object.";
    Id object = 0;
    std::vector<int> steps;
    bool operator==(const Unshape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a placed object", required.names_object());
        field("steps", c.steps, "numbers of the edits, from 1; empty: all", in_range(1, 1e6));
    }
};
Document applied(Document document, const Unshape& command);
StepTitle title(const Unshape& c, const StepDocuments& step);

} // namespace trivar

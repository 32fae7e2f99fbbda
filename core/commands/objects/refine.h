// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/refining_fields.h"

namespace trivar {

// Throws Rejected for a bound that does not hold.
void check(const Refining& refining);

struct Refine {
    static constexpr std::string_view verb = "refine",
                                      summary =
                                          "Split the triangles of bent objects until they are "
                                          "certified to be within a tolerance of the true surface.";
    std::vector<Id> objects;
    Refining refining;
    std::vector<Refining> refinings = {};
    bool operator==(const Refine&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects that lie on strokes or are in lattices",
              required.names_object());
        spread(c.refining, field);
        field("refinings", c.refinings,
              "one each, in the order of the objects, in place of these fields; empty: the same "
              "for all");
    }
    // The command that changes nothing of the object; none: it has nothing of the kind.
    static std::optional<Refine> as_it_is(const Object& object, Id id)
    {
        return Refine{{id}, object.refining.value_or(Refining{})};
    }
};
Document applied(Document document, const Refine& command);
StepTitle title(const Refine& c, const StepDocuments& step);

struct ClearRefine {
    static constexpr std::string_view verb = "clear_refine",
                                      summary = "Undo the refinement of objects.";
    std::vector<Id> objects;
    bool operator==(const ClearRefine&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of refined objects", required.names_object());
    }
};
Document applied(Document document, const ClearRefine& command);
StepTitle title(const ClearRefine& c, const StepDocuments& step);

} // namespace trivar

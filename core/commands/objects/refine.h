// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
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
    static constexpr auto sets = &Object::refining;
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
};
Document applied(Document document, const Refine& command);
StepTitle title(const Refine& c, const StepDocuments& step);

struct OfClearRefine {
    static constexpr std::string_view verb = "clear_refine",
                                      summary = "Undo the refinement of objects.",
                                      help = "ids of refined objects",
                                      title = "Give {} its own triangles back";
    static void change(Object& o) { o.refining.reset(); }
};
using ClearRefine = OnObjects<OfClearRefine>;

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/cutting_fields.h"

namespace trivar {

inline constexpr std::size_t most_cuts = 16, most_cut_points = 1000; // of one object; of one cut

struct CutThrough {
    static constexpr std::string_view
        verb = "cut",
        summary = "Cut objects in pieces by planes and by strokes that were drawn over them; the "
                  "pieces are closed, and move apart where there is a gap.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    static constexpr auto sets = &Object::cutting;
    std::vector<Id> objects;
    Cutting cutting;
    bool operator==(const CutThrough&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.cutting, field);
    }
};
Document applied(Document document, const CutThrough& command);
StepTitle title(const CutThrough& c, const StepDocuments& step);
// Throws Rejected where nothing can be cut like that.
void check(const Cutting& cutting);

struct RemoveCut {
    static constexpr std::string_view
        verb = "remove_cut",
        summary = "Remove one cut of an object; keys of the others stay with them.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    int number = 1;
    bool operator==(const RemoveCut&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of an object that is cut", required.names_object());
        field("number", c.number, "of the cut, from 1 on", in_range(1, most_cuts));
    }
};
Document applied(Document document, const RemoveCut& command);
StepTitle title(const RemoveCut& c, const StepDocuments& step);

struct OfClearCuts {
    static constexpr std::string_view verb = "clear_cuts",
                                      summary = "Make objects that are cut whole again.",
                                      help = "ids of objects that are cut", title = "Make {} whole";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
};
using ClearCuts = OnObjects<OfClearCuts>;
Document applied(Document document, const ClearCuts& command);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/splitting_fields.h"

namespace trivar {

inline constexpr std::size_t most_obstacles = 64; // of one object

struct Split {
    static constexpr std::string_view
        verb = "split",
        summary = "Let obstacles part objects: an object opens where an obstacle is in its way, "
                  "closes behind it, and stays solid.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    static constexpr auto sets = &Object::splitting;
    std::vector<Id> objects;
    Splitting splitting;
    bool operator==(const Split&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.splitting, field);
    }
};
Document applied(Document document, const Split& command);
StepTitle title(const Split& c, const StepDocuments& step);
// Throws Rejected where the object cannot be parted like that.
void check_splitting(const Document& document, Id id, const Splitting& splitting);

struct OfClearSplit {
    static constexpr std::string_view verb = "clear_split",
                                      summary = "Make objects that obstacles part whole again.",
                                      help = "ids of objects that are parted by obstacles",
                                      title = "Close {}";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    static void change(Object& o) { o.splitting.reset(); }
};
using ClearSplit = OnObjects<OfClearSplit>;

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/simplifying_fields.h"

namespace trivar {

struct Simplify {
    static constexpr std::string_view
        verb = "simplify",
        summary = "Reduce the triangles of objects, before anything else is done with them.";
    static constexpr auto sets = &Object::simplifying;
    std::vector<Id> objects;
    Simplifying simplifying;
    bool operator==(const Simplify&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.simplifying, field);
    }
};
Document applied(Document document, const Simplify& command);
StepTitle title(const Simplify& c, const StepDocuments& step);

struct OfClearSimplify {
    static constexpr std::string_view verb = "clear_simplify",
                                      summary = "Undo the simplification of objects.",
                                      help = "ids of simplified objects",
                                      title = "Give {} all triangles back";
    static constexpr CommandNature nature{.asked = Invocation::at_once};
    static void change(Object& o) { o.simplifying.reset(); }
};
using ClearSimplify = OnObjects<OfClearSimplify>;

} // namespace trivar

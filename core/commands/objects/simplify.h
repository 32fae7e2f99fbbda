// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/simplifying_fields.h"

namespace trivar {

struct Simplify {
    static constexpr std::string_view
        verb = "simplify",
        summary = "Reduce the triangles of objects, before anything else is done with them.";
    std::vector<Id> objects;
    Simplifying simplifying;
    bool operator==(const Simplify&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.simplifying, field);
    }
    static std::optional<Simplify> as_it_is(const Object& object, Id id)
    {
        return Simplify{{id}, object.simplifying.value_or(Simplifying{})};
    }
};
Document applied(Document document, const Simplify& command);
StepTitle title(const Simplify& c, const StepDocuments& step);

struct ClearSimplify {
    static constexpr std::string_view verb = "clear_simplify",
                                      summary = "Undo the simplification of objects.";
    static constexpr CommandNature nature{.asked = Invocation::at_once};
    std::vector<Id> objects;
    bool operator==(const ClearSimplify&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of simplified objects", required.names_object());
    }
};
Document applied(Document document, const ClearSimplify& command);
StepTitle title(const ClearSimplify& c, const StepDocuments& step);

} // namespace trivar

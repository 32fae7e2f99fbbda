// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/on_objects.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/unwrapping_fields.h"

namespace trivar {

struct Unwrap {
    static constexpr std::string_view
        verb = "unwrap",
        summary = "Give objects new UVs (texture coordinates), in place of those of their files: "
                  "the surface is cut into charts, which are laid flat and packed into a square.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    static constexpr auto sets = &Object::unwrapping;
    std::vector<Id> objects;
    Unwrapping unwrapping;
    bool operator==(const Unwrap&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.unwrapping, field);
    }
};
Document applied(Document document, const Unwrap& command);
StepTitle title(const Unwrap& c, const StepDocuments& step);

struct OfClearUnwrap {
    static constexpr std::string_view verb = "clear_unwrap",
                                      summary =
                                          "Give unwrapped objects the UVs of their files back.",
                                      help = "ids of unwrapped objects",
                                      title = "Give {} its own UVs back";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    static void change(Object& o) { o.unwrapping.reset(); }
};
using ClearUnwrap = OnObjects<OfClearUnwrap>;

} // namespace trivar

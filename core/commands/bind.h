// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/field.h"

namespace trivar {

struct Bind {
    static constexpr std::string_view
        verb = "bind",
        summary = "Let objects depend on another object in place of those "
                  "that they lie on, are painted on, mixed with, turn into, "
                  "are masked, parted or opened by.";
    static constexpr CommandNature nature{.icon = CommandIcon::group,
                                          .asked = Invocation::by_actions};
    std::vector<Id> objects, from;
    Id to = 0;
    bool operator==(const Bind&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of the objects that depend on others",
              required.names_object());
        field("from", c.from,
              "ids of what they depend on now; empty: what they lay or were painted on was deleted",
              any_value.names_object());
        field("to", c.to, "id of the object that takes the place of those",
              required.names_object());
    }
};
Document applied(Document document, const Bind& command);
StepTitle title(const Bind& c, const StepDocuments& step);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/import_fields.h"

namespace trivar {

struct KeepShape {
    static constexpr std::string_view
        verb = "keep_shape",
        summary = "Delete a lattice and keep its bend: objects in it become models from files in "
                  "their bent shape. Objects that are not named get their original shape back.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    std::vector<Id> members;
    std::vector<ImportedFile> files;
    bool operator==(const KeepShape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required.names_object());
        field("members", c.members, "ids of objects in it", required.names_object());
        field("files", c.files,
              "one per member, in the same order: its shape in the space of the group that it is "
              "in afterwards",
              required);
    }
};
Document applied(Document document, const KeepShape& command);
StepTitle title(const KeepShape& c, const StepDocuments& step);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/step_title.h"
#include "core/document/fields/import_fields.h"

namespace trivar {

struct KeepShape {
    static constexpr std::string_view verb = "keep_shape",
                                      summary = "Delete a lattice and keep the shape that it gave: "
                                                "objects in it become models from files that hold "
                                                "them as they are. What is not named goes back to "
                                                "rest.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    Id object = 0;
    std::vector<Id> members;
    std::vector<ImportedFile> files;
    bool operator==(const KeepShape&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "id of a lattice", required);
        field("members", c.members, "ids of objects in it", required);
        field(
            "files", c.files,
            "of the members, in the same order: their shapes in the space of the group that holds "
            "them then",
            required);
    }
};
Document applied(Document document, const KeepShape& command);
StepTitle title(const KeepShape& c, const StepDocuments& step);

} // namespace trivar

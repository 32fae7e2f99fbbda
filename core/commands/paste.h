// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/copied_object.h"
#include "core/commands/words/step_title.h"

namespace trivar {

struct Paste {
    static constexpr std::string_view
        verb = "paste",
        summary = "Add copies of objects. A placed one lies on the copy of its host, or on the "
                  "host itself if the scene has it; if not, it lies on all that is there, or is "
                  "straight if there is nothing.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    std::vector<CopiedObject> copies;
    bool operator==(const Paste&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("copies", c.copies, "the objects; they get the next ids in this order", required);
    }
};
Document applied(Document document, const Paste& command);
StepTitle title(const Paste& c, const StepDocuments& step);

// Copies of the objects, groups with their contents, for this scene or another one. The files of
// models are named from the root. An object from a group that is not copied keeps its place in the
// world. Ids that are not in the document are skipped.
Paste copied(const Document& document, const std::vector<Id>& ids, const std::string& folder);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/surfacing_fields.h"

namespace trivar {

struct SetMaterial {
    static constexpr std::string_view verb = "set_material",
                                      summary = "Override the materials of objects with one.";
    static constexpr CommandNature nature{.icon = CommandIcon::material};
    static constexpr auto sets = &Object::surfacing;
    std::vector<Id> objects;
    Surfacing surfacing;
    bool operator==(const SetMaterial&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required.names_object());
        spread(c.surfacing, field);
    }
};
Document applied(Document document, const SetMaterial& command);
StepTitle title(const SetMaterial& c, const StepDocuments& step);

struct ClearMaterial {
    static constexpr std::string_view verb = "clear_material",
                                      summary = "Restore the original materials of objects.";
    static constexpr CommandNature nature{.icon = CommandIcon::material,
                                          .asked = Invocation::at_once};
    std::vector<Id> objects;
    bool operator==(const ClearMaterial&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required.names_object());
    }
};
Document applied(Document document, const ClearMaterial& command);
StepTitle title(const ClearMaterial& c, const StepDocuments& step);

} // namespace trivar

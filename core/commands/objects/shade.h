// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/shading_fields.h"

namespace trivar {

struct Shade {
    static constexpr std::string_view
        verb = "shade",
        summary = "Show objects smooth, with edges where faces meet at more than an angle, or with "
                  "flat faces.";
    static constexpr CommandNature nature{.asked = Invocation::by_actions};
    static constexpr auto sets = &Object::shading;
    std::vector<Id> objects;
    FaceShading shading;
    bool operator==(const Shade&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of objects with a shape", required.names_object());
        spread(c.shading, field);
    }
};
Document applied(Document document, const Shade& command);
StepTitle title(const Shade& c, const StepDocuments& step);

} // namespace trivar

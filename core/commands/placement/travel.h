// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/travel_fields.h"

namespace trivar {

struct SetTravel {
    static constexpr std::string_view
        verb = "set_travel",
        summary = "Make placed objects travel along their strokes, or stop.";
    static constexpr auto sets = &Object::travel;
    std::vector<Id> objects;
    Travel travel;
    std::vector<Travel> travels = {};
    bool operator==(const SetTravel&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of placed objects", required.names_object());
        spread(c.travel, field);
        field("travels", c.travels,
              "one each, in the order of the objects, in place of these fields; empty: the same "
              "for all");
    }
};
Document applied(Document document, const SetTravel& command);
StepTitle title(const SetTravel& c, const StepDocuments& step);

} // namespace trivar

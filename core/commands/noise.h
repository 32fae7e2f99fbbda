// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/step_title.h"
#include "core/document/fields/noise_fields.h"

namespace trivar {

struct AddNoise {
    static constexpr std::string_view verb = "noise", summary = "Shift the vertices of objects.";
    std::vector<Id> objects;
    Noise noise;
    bool operator==(const AddNoise&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required);
        FieldsOf<Noise>::fields(c.noise, field);
    }
};
Document applied(Document document, const AddNoise& command);
StepTitle title(const AddNoise& c, const StepDocuments& step);

} // namespace trivar

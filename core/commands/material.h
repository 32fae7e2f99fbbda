// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/surfacing_fields.h"

namespace trivar {

struct SetMaterial {
    static constexpr std::string_view verb = "set_material",
                                      summary = "Cover objects with one plain material.";
    std::vector<Id> objects;
    Surfacing surfacing;
    bool operator==(const SetMaterial&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids", required);
        FieldsOf<Surfacing>::fields(c.surfacing, field);
    }
};
struct ClearMaterial {
    static constexpr std::string_view verb = "clear_material",
                                      summary = "Give objects their own materials back.";
    std::vector<Id> objects;
    bool operator==(const ClearMaterial&) const = default;
    static void fields(auto& c, auto&& field) { field("objects", c.objects, "ids", required); }
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Surfacing> {
    static void fields(auto& s, auto&& field)
    {
        field("base_color", s.base_color, "linear red, green, blue and opacity", between(0, 1));
        field("metallic", s.metallic, "0: not a metal, 1: a metal", between(0, 1));
        field("roughness", s.roughness, "0: a mirror, 1: chalk", between(0, 1));
        field("solid", s.solid,
              "what fills it and deforms with it; the colour tints it, its roughness is its own",
              later);
    }
};

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/copy_fields.h"

namespace trivar {

template <> struct FieldsOf<Copied<Splitting>> {
    static constexpr std::string_view told_as = FieldsOf<Splitting>::copied_as;
    static void fields(auto& c, auto&& field)
    {
        spread(c.value, field);
        copy_fields<Splitting>(c.names, field)
            .list_bases("known", c.value, "the obstacles: other copies, or objects of the scene");
    }
};

// A CopiedObject is an object by itself, with its number in the scene from which it was copied.
struct CopiedObject {
    Id object = 0;
    Object value = {};                          // its ids are those of that scene
    KnownNames names = {};                      // of what it depends on
    bool operator==(const CopiedObject&) const; // by value, not by what is shared
};
template <> struct FieldsOf<CopiedObject> {
    static constexpr std::string_view told_as = "[object](#object)",
                                      about = "An object as it is copied.";
    static void fields(auto& c, auto&& field)
    {
        field("object", c.object, "its id when it was copied, by which other copies name it",
              required.names_object());
        // A walk through names keeps where they are, so that it sees the object itself.
        if constexpr (requires { field.spread(c.value); }) return field.spread(c.value);
        const auto copied = copy_fields<Object>(c.names, field);
        using Own = FieldsOf<Object>;
        Own::shape(c.value, copied);
        Own::state(c.value, copied);
        Own::material(c.value, copied);
        Own::steps(c.value, copied);
        copied.list_bases("blades", c.value.incising,
                          "the blades of its incisions: other copies, or objects of the scene");
        Own::layers(c.value, copied);
    }
};

// Checks each value of an object as the command that gives it to an object does. Throws Rejected.
void check_values(const Object& object);

} // namespace trivar

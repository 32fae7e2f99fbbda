// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/fields/object_fields.h"

#include <map>
#include <string>
#include <vector>

namespace trivar {

// A KnownObject is an object on which a copy depends. Both number and name must fit, so that
// another scene's object of that number is not taken for it.
struct KnownObject {
    Id object = 0;
    std::string name;
    bool operator==(const KnownObject&) const = default;
};
template <> struct FieldsOf<KnownObject> {
    static constexpr std::string_view told_as = "[base](#base)",
                                      about = "What a copied object lay on, or was painted on.";
    static void fields(auto& k, auto&& field)
    {
        field("object", k.object, "its id", required.names_object());
        field("name", k.name,
              "its name, so that another object of the same id is not mistaken for it", required);
    }
};
using KnownNames = std::map<Id, std::string>; // of objects, by their ids where they were copied
KnownObject known(const KnownNames& names, Id id);

// A Copied value comes with the names of the objects on which it depends.
template <class T> struct Copied {
    T value = {};
    KnownNames names = {};
};

// as_copied() returns the value that a copy holds in place of a value, with the names of the
// objects that it depends on; as_named() returns the value of such a one, and adds its names.
template <class T> auto as_copied(const T& value, const KnownNames& names)
{
    if constexpr (is_ref<T>)
        return *value;
    else if constexpr (std::is_same_v<T, Tracks>)
        return value.all();
    else if constexpr (requires { FieldsOf<T>::copied_as; })
        return Copied<T>{value, names};
    else if constexpr (is_optional<T>) {
        std::optional<decltype(as_copied(*value, names))> out;
        if (value) out = as_copied(*value, names);
        return out;
    } else if constexpr (is_list<T>) {
        std::vector<decltype(as_copied(value[0], names))> out;
        for (const auto& each : value) out.push_back(as_copied(each, names));
        return out;
    } else
        return value;
}
template <class T> T as_named(const auto& copy, KnownNames& names)
{
    if constexpr (is_ref<T>)
        return make_ref(copy);
    else if constexpr (requires { FieldsOf<T>::copied_as; }) {
        for (const auto& [id, name] : copy.names) names.insert_or_assign(id, name);
        return copy.value;
    } else if constexpr (is_optional<T>)
        return copy ? T(as_named<typename T::value_type>(*copy, names)) : T();
    else if constexpr (is_list<T>) {
        T out;
        for (const auto& each : copy) out.push_back(as_named<typename T::value_type>(each, names));
        return out;
    } else
        return copy;
}

} // namespace trivar

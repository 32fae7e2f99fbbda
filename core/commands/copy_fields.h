// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/known_object.h"
#include "core/document/each_name.h"

// A copy of an object has the fields of an object, but for what a line of JSON needs: a field for
// each shape that it can have, no values at rest, and what it depends on by name, too.

namespace trivar {

// The field of a shape among those of a copy: "box" for what add_box adds.
template <class Shape> constexpr std::string_view shape_field()
{
    if constexpr (requires { FieldsOf<Shape>::copied; })
        return FieldsOf<Shape>::copied;
    else
        return FieldsOf<Shape>::verb.substr(std::string_view("add_").size());
}
[[noreturn]] void refuse_second_shape(std::string_view field);

// CopyFields turns the fields of an owner into those of a copy of it. A copy that is const is
// written, with the names that are known; another one is read, and its names are noted.
template <class Owner, class Names, class Field> struct CopyFields {
    Names& names;
    Field& field;

    template <class V>
    void operator()(std::string_view name, V& value, std::string_view help,
                    const Rule& rule = {}) const
    {
        using T = std::remove_const_t<V>;
        if (!rule.in_copies.empty()) name = rule.in_copies;
        [[maybe_unused]] const auto tell = [&](auto as, [[maybe_unused]] auto&& taken) {
            field(name, as, help, Rule{.required = rule.required});
            if constexpr (!std::is_const_v<V>) value = taken(as);
        };
        [[maybe_unused]] const auto take = [&](const KnownObject& base) {
            if constexpr (!std::is_const_v<Names>) names.insert_or_assign(base.object, base.name);
            return base.object;
        };
        if constexpr (is_choice<T>)
            shapes(value, static_cast<const T*>(nullptr));
        else if constexpr (std::is_same_v<T, std::optional<RoundWay>>) {
            bool given = value.has_value();
            RoundWay way = value.value_or(RoundWay{});
            field(name, given, help);
            FieldsOf<RoundWay>::fields(way, field);
            if constexpr (!std::is_const_v<V>) value = given ? T(way) : T();
        } else if constexpr (std::is_same_v<Owner, Object> && Nested<T>) {
            if (rule.counted == Counting::always) return field(name, value, help, rule);
            tell(value == T{} ? std::optional<T>() : std::optional<T>(value),
                 [](const auto& unless_at_rest) { return unless_at_rest.value_or(T{}); });
        } else if constexpr (std::is_same_v<T, Id>) {
            if (rule.use.empty()) return field(name, value, help, rule);
            if (rule.required) return tell(known(names, value), take);
            tell(value == 0 ? std::optional<KnownObject>() : known(names, value),
                 [&](const auto& base) { return base ? take(*base) : 0; });
        } else if constexpr (std::is_same_v<T, std::vector<Id>>) {
            std::vector<KnownObject> all;
            for (const Id id : value) all.push_back(known(names, id));
            tell(all, [&](const auto& read) {
                T ids;
                for (const KnownObject& each : read) ids.push_back(take(each));
                return ids;
            });
        } else if constexpr (std::is_same_v<decltype(as_copied(value, names)), T>)
            field(name, value, help, rule);
        else
            tell(as_copied(value, names),
                 [&](const auto& copy) { return as_named<T>(copy, names); });
    }
    // Lists what a value depends on, where it holds the ids alone, in a field of its own.
    void list_bases(std::string_view name, auto& value, std::string_view help) const
    {
        std::vector<KnownObject> list;
        each_id(value, [&](Id id, const Rule& rule) {
            if (id != 0 && !rule.use.empty()) list.push_back(known(names, id));
        });
        field(name, list, help, later);
        if constexpr (!std::is_const_v<Names>)
            for (const KnownObject& each : list) names.insert_or_assign(each.object, each.name);
    }

private:
    template <class... Shape>
    void shapes(auto& source, const std::variant<GroupShape, Shape...>*) const
    {
        (shape<Shape>(source), ...);
    }
    template <class Shape> void shape(auto& source) const
    {
        std::optional<Shape> own;
        if (const Shape* is = std::get_if<Shape>(&source)) own = *is;
        field(shape_field<Shape>(), own, "its shape; a copy has one, and a group none");
        if constexpr (!std::is_const_v<std::remove_reference_t<decltype(source)>>) {
            const bool was = std::holds_alternative<Shape>(source);
            if (own && !was && !std::holds_alternative<GroupShape>(source))
                refuse_second_shape(shape_field<Shape>());
            if (own || was) source = own ? Source(*std::move(own)) : Source(GroupShape{});
        }
    }
};
template <class Owner, class Names, class Field>
CopyFields<Owner, Names, Field> copy_fields(Names& names, Field& field)
{
    return {names, field};
}

template <class T> struct FieldsOf<Copied<T>> {
    static constexpr std::string_view told_as = FieldsOf<T>::copied_as,
                                      about = "As it is told of a copied object.";
    static void fields(auto& c, auto&& field)
    {
        FieldsOf<T>::fields(c.value, copy_fields<T>(c.names, field));
    }
};

} // namespace trivar

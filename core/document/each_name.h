// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

// Walks through the objects and the files that a value names, by the rules of its fields: through
// an object, a command, a shape, a step of one.

namespace trivar {

// Whether values of a type can name an object or a file, as it or what it holds says in a list of
// fields. Walks leave out all others: samples of strokes are many.
template <class T> bool can_name()
{
    if constexpr (Nested<T>) {
        static const bool found = [] {
            T probe{};
            bool any = false;
            FieldsOf<T>::fields(
                probe, [&]<class V>(std::string_view, V&, std::string_view, const Rule& rule = {}) {
                    any = any || rule.object || rule.file || can_name<V>();
                });
            return any;
        }();
        return found;
    } else if constexpr (is_optional<T> || is_list<T>)
        return can_name<typename T::value_type>();
    else if constexpr (is_ref<T>)
        return can_name<std::remove_const_t<typename T::element_type>>();
    else if constexpr (is_choice<T>)
        return []<class... One>(const std::variant<One...>*) {
            return (can_name<One>() || ...);
        }(static_cast<const T*>(nullptr));
    else
        return false;
}

// Calls leaf(value, rule, owner, entry) for each number and text below a value, of those that can
// name something. `owner` is what lists the field; `entry` is the number of the entry of the list
// that has it, from 1; 0: no list has it.
template <class V, class Owner, class Leaf>
void walk_names(V& value, const Rule& rule, Owner& owner, int entry, Leaf& leaf);

template <class Owner, class Leaf> struct NameWalk {
    Owner& owner;
    int entry;
    Leaf& leaf;
    template <class V>
    void operator()(std::string_view, V& value, std::string_view, const Rule& rule = {}) const
    {
        walk_names(value, rule, owner, entry, leaf);
    }
    template <class V> void spread(V& value) const { walk_names(value, {}, owner, entry, leaf); }
};

template <class V, class Owner, class Leaf>
void walk_names(V& value, const Rule& rule, Owner& owner, int entry, Leaf& leaf)
{
    using T = std::remove_const_t<V>;
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::string>)
        leaf(value, rule, owner, entry);
    else if constexpr (std::is_same_v<T, std::vector<int>>)
        for (auto& each : value) leaf(each, rule, owner, entry);
    else if constexpr (is_optional<T>) {
        if (value) walk_names(*value, rule, owner, entry, leaf);
    } else if constexpr (is_list<T> || is_choice<T> || is_ref<T> || Nested<T>) {
        if (!can_name<T>()) return;
        if constexpr (Nested<T>)
            FieldsOf<T>::fields(value, NameWalk<V, Leaf>{value, entry, leaf});
        else if constexpr (is_list<T>)
            for (std::size_t i = 0; i < value.size(); ++i)
                walk_names(value[i], rule, owner, static_cast<int>(i) + 1, leaf);
        else if constexpr (is_choice<T>)
            std::visit([&](auto& chosen) { walk_names(chosen, rule, owner, entry, leaf); }, value);
        else if constexpr (std::is_const_v<V>)
            walk_names(*value, rule, owner, entry, leaf);
        else {
            std::remove_const_t<typename T::element_type> changed = *value;
            walk_names(changed, rule, owner, entry, leaf);
            if (changed != *value) value = make_ref(std::move(changed));
        }
    }
}

// The same for an object, a command or any other value.
template <class T> void each_name(T& value, auto&& leaf)
{
    if constexpr (requires { T::fields(value, leaf); })
        T::fields(value, NameWalk<T, std::remove_reference_t<decltype(leaf)>>{value, 0, leaf});
    else
        walk_names(value, {}, value, 0, leaf);
}

// Calls visit(id, rule) for each id of an object, which can be changed if the value can; 0: none.
template <class T> void each_id(T& value, auto&& visit)
{
    each_name(value, [&]<class V>(V& leaf, const Rule& rule, auto&, int) {
        if constexpr (std::is_same_v<std::remove_const_t<V>, int>)
            if (rule.object) visit(leaf, rule);
    });
}

// A FileName is the path of a file in a field, with what its list of fields says of it.
template <class Text> struct FileName {
    FileKind kind;
    Text& path;   // empty: none
    Text& digest; // of the content that was meant; empty: any
    bool in_use;  // false: what names it does not read it at present
    int entry;    // as of each_name()
};
// Calls visit(name, owner) for each of them.
template <class T> void each_file(T& value, auto&& visit)
{
    using Text = std::conditional_t<std::is_const_v<T>, const std::string, std::string>;
    Text* path = nullptr;
    std::optional<FileKind> kind;
    bool in_use = false;
    each_name(value, [&]<class V>(V& leaf, const Rule& rule, auto& owner, int entry) {
        if constexpr (std::is_same_v<V, Text>) {
            if (rule.file) {
                path = &leaf;
                kind = rule.file;
                in_use = rule.in_use;
            } else if (rule.digest && kind)
                visit(FileName<Text>{*kind, *path, leaf, in_use, entry}, owner);
        }
    });
}

} // namespace trivar

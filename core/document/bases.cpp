// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/bases.h"

#include "core/document/each_name.h"
#include "core/document/fields/object_fields.h"

#include <set>

namespace trivar {
namespace {

using Other = std::function<Id(Id)>;

// Gives a value other bases. Returns the id of the base that it must have, 0 if it must have none;
// nothing: that base is gone, and the value goes with it.
template <class T> std::optional<Id> rebased(T& value, const Rule& rule, const Other& other)
{
    if constexpr (std::is_same_v<T, Id>) {
        if (rule.use.empty()) return 0;
        if (value != 0) value = other(value);
        if (!rule.required) return 0;
        if (value == 0) return {};
        return value;
    } else if constexpr (std::is_same_v<T, std::optional<Attachment>>) {
        if (value)
            value = renumbered(*value, [&](Id id) {
                const Id now = other(id);
                return now == 0 ? std::nullopt : std::optional(now);
            });
    } else if constexpr (is_optional<T>) {
        if (value && !rebased(*value, rule, other)) value.reset();
    } else if constexpr (is_list<T>) {
        if (!std::is_same_v<T, std::vector<Id>> && !can_name<T>()) return 0;
        Rule of_entry = rule;
        of_entry.required = true;
        std::set<Id> seen; // each base once
        T rest;
        for (auto& entry : value) {
            const std::optional<Id> base = rebased(entry, of_entry, other);
            if (base && (*base == 0 || seen.insert(*base).second)) rest.push_back(std::move(entry));
        }
        const bool lost_all = !value.empty() && rest.empty();
        value = std::move(rest);
        if (lost_all && rule.required) return {};
    } else if constexpr (is_choice<T>) {
        return std::visit([&](auto& chosen) { return rebased(chosen, rule, other); }, value);
    } else if constexpr (is_ref<T>) {
        if (!can_name<T>()) return 0;
        std::remove_const_t<typename T::element_type> changed = *value;
        const std::optional<Id> base = rebased(changed, rule, other);
        if (changed != *value) value = make_ref(std::move(changed));
        return base;
    } else if constexpr (Nested<T>) {
        std::optional<Id> base = 0;
        if (can_name<T>())
            each_field(value, [&](std::string_view, auto& inner, std::string_view,
                                  const Rule& inner_rule = {}) {
                const std::optional<Id> needed = rebased(inner, inner_rule, other);
                if (!needed)
                    base.reset();
                else if (base && *needed != 0)
                    base = needed;
            });
        return base;
    }
    return 0;
}

} // namespace

std::vector<BaseUse> bases_of(const Object& object)
{
    std::vector<BaseUse> out;
    each_id(object, [&](Id id, const Rule& rule) {
        if (id != 0 && !rule.use.empty()) out.push_back({id, rule.use});
    });
    return out;
}

Object with_bases(Object object, const Other& other)
{
    rebased(object, {}, other);
    return object;
}

} // namespace trivar

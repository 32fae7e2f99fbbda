// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document_digest.h"

#include "core/base/digest.h"
#include "core/document/fields/object_fields.h"

#include <span>

namespace trivar {
namespace {

template <class T> void add(Digest& digest, const T& value);

template <class T> bool is_default(const T& value, const Rule& rule)
{
    if constexpr (requires {
                      T(rule.rest);
                      value == T(rule.rest);
                  } &&
                  !is_optional<T> && !is_list<T>)
        return value == T(rule.rest);
    else
        return value == T{};
}

template <class T>
void add_field(Digest& digest, std::string_view name, const T& value, const Rule& rule)
{
    const Counting counted = rule.counted;
    if (counted != Counting::always && is_default(value, rule)) return;
    if (counted == Counting::named || counted == Counting::marked) digest.add_text(name);
    if constexpr (is_optional<T>) {
        if (counted == Counting::marked) return add(digest, *value);
    } else if constexpr (std::is_same_v<T, bool>) {
        if (counted == Counting::marked) return;
    } else if constexpr (is_list<T>)
        if (counted == Counting::marked) {
            for (const auto& entry : value) add(digest, entry);
            return;
        }
    add(digest, value);
}

template <class T> void add(Digest& digest, const T& value)
{
    if constexpr (Nested<T>)
        each_field(value, [&](std::string_view name, const auto& field, std::string_view = {},
                              const Rule& rule = {}) { add_field(digest, name, field, rule); });
    else if constexpr (std::is_convertible_v<T, std::string_view>)
        digest.add_text(value);
    else if constexpr (is_optional<T>) {
        digest.add(value.has_value());
        if (value) add(digest, *value);
    } else if constexpr (is_choice<T>) {
        digest.add(static_cast<std::uint64_t>(value.index()));
        std::visit([&](const auto& chosen) { add(digest, chosen); }, value);
    } else if constexpr (is_ref<T>)
        add(digest, *value);
    else if constexpr (std::is_same_v<T, Tracks>)
        add(digest, value.all());
    else if constexpr (is_list<T>) {
        using Entry = typename T::value_type;
        digest.add(static_cast<std::uint64_t>(value.size()));
        if constexpr (is_list<Entry> || Nested<Entry> || is_ref<Entry>)
            for (const auto& entry : value) add(digest, entry);
        else
            digest.add(std::span<const Entry>(value));
    } else
        digest.add(value);
}

} // namespace

std::string digest(const Document& document)
{
    Digest digest;
    for (const auto& [id, ref] : document.objects) {
        digest.add(id);
        add(digest, *ref);
    }
    digest.add(document.next_id);
    for (const auto& [name, camera] : document.kept_views) {
        digest.add_text(name);
        add(digest, camera);
    }
    add(digest, *document.render);
    if (!document.rows->empty()) add(digest, *document.rows);
    if (document.time != Time{}) { // older scenes have none
        digest.add_text("time");
        add(digest, document.time);
    }
    if (!document.tracks->empty()) {
        digest.add_text("tracks");
        add(digest, *document.tracks);
    }
    return digest.hex();
}

} // namespace trivar

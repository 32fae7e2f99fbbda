// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "core/document/field.h"

#include <cmath>

namespace trivar {

std::string json_text(std::string_view text); // quoted
std::string json_text(double value);          // the shortest that reads back as the same bits
std::string json_text(float value);

// Adds the separator, which becomes a comma, and "name":value.
void append_field(std::string& text, std::string_view& separator, std::string_view name,
                  const std::string& value);
template <class T> std::string fields_json(const T& value, std::string_view separator = "");

// Any value of a command as JSON, without spaces.
template <class T> std::string value_json(const T& value)
{
    const auto list = [](std::size_t count, auto&& entry) {
        std::string text = "[";
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) text += ',';
            text += entry(i);
        }
        return text + ']';
    };
    if constexpr (Nested<T>)
        return "{" + fields_json(value) + "}";
    else if constexpr (std::is_same_v<T, bool>)
        return value ? "true" : "false";
    else if constexpr (std::is_same_v<T, int>)
        return std::to_string(value);
    else if constexpr (std::is_enum_v<T>)
        return json_text(choice_names<T>.at(static_cast<std::size_t>(value)));
    else if constexpr (std::is_same_v<T, StrokeSample>)
        return "[" + json_text(value.p_px.x) + "," + json_text(value.p_px.y) + "," +
               json_text(value.time_s) + "," + json_text(value.pressure) + "]";
    else if constexpr (is_list<T>)
        return list(value.size(), [&](std::size_t i) { return value_json(value[i]); });
    else if constexpr (requires { T::length(); })
        return list(static_cast<std::size_t>(T::length()),
                    [&](std::size_t i) { return value_json(value[static_cast<int>(i)]); });
    else
        return json_text(value);
}

// All fields as "name":value,... with a separator before each one; the first separator is the given
// one. An empty optional is left out.
template <class T> std::string fields_json(const T& value, std::string_view separator)
{
    std::string text;
    each_field(value, [&]<class V>(std::string_view name, const V& v, auto&&...) {
        if constexpr (is_optional<V>) {
            if (v) append_field(text, separator, name, value_json(*v));
        } else
            append_field(text, separator, name, value_json(v));
    });
    return text;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/field_words.h"
#include "core/commands/words/step_title.h"

#include <string>
#include <vector>

// Changes holds what differs between two values of a command, for the titles of steps.

namespace trivar {

struct Change {
    std::string name, value; // the field as a panel calls it; its present value with its unit
};
using Changes = std::vector<Change>;

// A colour as designers write it: sRGB, #RRGGBB. `linear` is red, green and blue in 0..1.
std::string color_text(const glm::vec3& linear);

// A value as a person says it: "0.24 m", "bridged", "40 × 9 × 4", "2 points".
template <class V> std::string value_words(const V& value, const Rule& rule)
{
    if constexpr (std::is_same_v<V, bool>)
        return std::string(value ? rule.yes : rule.no);
    else if constexpr (std::is_enum_v<V>) {
        const auto at = static_cast<std::size_t>(value);
        if constexpr (choice_words<V>.size() > 0) return std::string(choice_words<V>.at(at));
        std::string words(choice_names<V>.at(at));
        for (char& c : words) c = c == '_' ? ' ' : c;
        return words;
    } else if constexpr (std::is_same_v<V, std::string>)
        return value;
    else if constexpr (std::is_arithmetic_v<V>)
        return value == V{} && !rule.zero.empty()
                   ? std::string(rule.zero)
                   : with_unit(static_cast<double>(value), rule.unit);
    else if constexpr (is_list<V>) {
        if (value.empty() && !rule.zero.empty()) return std::string(rule.zero);
        if constexpr (is_list<typename V::value_type>)
            return std::to_string(value.size()) + " × " +
                   std::to_string(value.empty() ? 0 : value[0].size()) + " points";
        return std::to_string(value.size()) + " points";
    } else if constexpr (requires { V::length(); }) {
        std::string text;
        for (int i = 0; i < V::length(); ++i)
            text += (i > 0 ? " × " : "") + with_unit(static_cast<double>(value[i]),
                                                     i + 1 < V::length() ? Unit::none : rule.unit);
        return text;
    } else
        return {};
}

// The fields that differ between two values of one type, in their order. The opacity of a colour
// counts as a field of its own.
template <class T> Changes changes(const T& before, const T& after)
{
    std::vector<const void*> then;
    each_field(after, [&](std::string_view, const auto& v, auto&&...) { then.push_back(&v); });
    Changes out;
    std::size_t next = 0;
    each_field(before, [&]<class V>(std::string_view name, const V& was, std::string_view,
                                    const Rule& rule = {}) {
        const V& is = *static_cast<const V*>(then[next++]);
        if (is == was) return;
        if constexpr (std::is_same_v<V, glm::vec4>) {
            const glm::vec3 color(is);
            if (color != glm::vec3(was)) out.push_back({label_of(name, rule), color_text(color)});
            if (is.w != was.w) out.push_back({"Opacity", number_text(is.w)});
        } else
            out.push_back({label_of(name, rule), value_words(is, rule)});
    });
    return out;
}

// The title for changes: "Width of Snake" "0.24 m"; "Width and height of Snake"; `whole` "of Snake"
// where more fields changed.
StepTitle title_of_changes(const Changes& changes, const std::string& whole,
                           const std::string& object);

} // namespace trivar

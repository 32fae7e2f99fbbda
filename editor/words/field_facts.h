// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/field_words.h"

#include <string>
#include <type_traits>
#include <vector>

namespace trivar {

// FieldFacts are the facts of one member of a value in the list of fields.
struct FieldFacts {
    std::string name, help;
    Rule rule;
};
template <class T, class V> FieldFacts facts_of(V T::*member)
{
    const T probe{};
    FieldFacts found;
    each_field(probe, [&]<class Each>(std::string_view name, const Each& each,
                                      std::string_view help, const Rule& rule = {}) {
        if constexpr (std::is_same_v<Each, V>)
            if (&each == &(probe.*member)) found = {std::string(name), std::string(help), rule};
    });
    return found;
}

// Returns the words that panels use for the values of an enumeration, in their order.
template <class E> std::vector<std::string> choices_in_words()
{
    std::vector<std::string> words;
    const auto add = [&](const auto& names) {
        for (const std::string_view name : names) words.push_back(in_words(name));
    };
    if constexpr (choice_words<E>.empty())
        add(choice_names<E>);
    else
        add(choice_words<E>);
    return words;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/panels/inspector/axis_number.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/words/field_facts.h"
#include "editor/words/field_words.h"

#include <algorithm>
#include <functional>

namespace trivar {

// Returns how a field shows its number: range, step, unit and the meaning of 0, from its rule.
// `mixed`: it differs among objects that change together. `zero` replaces what the rule says of 0.
ui::NumberStyle number_style(const Rule& rule, bool mixed, std::string_view zero);

// A row for a text that is one of those that its rule lists.
void text_choice(ValueRows& rows, const std::string& label, std::string& value,
                 const std::string& rest, const Rule& rule, const RowWords& words);

// Rows for members of a value, from its list of fields: label, range, unit, words, sentence and
// the names of its keys come from there. Where several objects change together, what differs
// among them says so.
template <class T> class FieldRows {
public:
    // `parameter`: what the names of its keys begin with, "placement". `all`: the values of all
    // objects, `value` that of the active one among them; empty: there is one object.
    FieldRows(ValueRows& rows, T& value, std::string parameter, const std::vector<T>& all = {})
        : rows_(rows),
          value_(value),
          before_(value),
          parameter_(std::move(parameter)),
          all_(all)
    {
    }
    // Edits a member; `zero` is the meaning of 0, in place of the one in the list.
    template <class V> void operator()(V T::*member, std::string_view zero = {})
    {
        row(member, T{}.*member, zero);
    }
    template <class V> void resting_at(const V& rest, V T::*member) { row(member, rest, {}); }
    // Edits a length that at 0 has a value already, `present`, metres; 0: not known.
    void size(double T::*member, double present)
    {
        const FieldFacts field = facts_of(member);
        rows_.size(label_of(field.name, field.rule), value_.*member, present, words(field));
    }
    template <class V> RowWords words_of(V T::*member) const { return words(facts_of(member)); }
    template <class V> static std::string label(V T::*member)
    {
        const FieldFacts field = facts_of(member);
        return label_of(field.name, field.rule);
    }
    // Puts what a hand took in this frame into the value of another object.
    void put_into(T& other) const
    {
        for (const auto& put : taken_) put(other);
    }

private:
    RowWords words(const FieldFacts& field) const
    {
        const std::string help = without_unit(field.help);
        if (field.rule.fixed || parameter_.empty()) return RowWords(help);
        return {help, parameter_ + "." + field.name};
    }
    template <class V> void row(V T::*member, const V& rest, std::string_view zero)
    {
        const ui::Edit others = std::exchange(rows_.edit, ui::Edit::none);
        draw(member, rest, zero);
        if (rows_.edit == ui::Edit::changed)
            taken_.push_back([member, was = before_.*member, now = value_.*member](T& other) {
                if constexpr (std::is_same_v<V, glm::dvec3> || std::is_same_v<V, glm::vec3>) {
                    for (int axis = 0; axis < 3; ++axis) // of a reset all that are not at rest
                        if (now[axis] != was[axis]) (other.*member)[axis] = now[axis];
                } else
                    other.*member = now;
            });
        if (rows_.edit == ui::Edit::none) rows_.edit = others;
    }
    template <class V> void draw(V T::*member, const V& rest, std::string_view zero)
    {
        const FieldFacts field = facts_of(member);
        const std::string label = label_of(field.name, field.rule);
        const bool mixed = std::ranges::any_of(
            all_, [&](const T& each) { return !(each.*member == before_.*member); });
        const ui::NumberStyle style = number_style(field.rule, mixed, zero);
        V& value = value_.*member;
        if constexpr (std::is_same_v<V, bool>)
            rows_.check(label, value, rest, std::string(field.rule.yes), words(field));
        else if constexpr (std::is_enum_v<V>)
            choice(label, value, rest, choices_in_words<V>(), mixed, words(field));
        else if constexpr (std::is_same_v<V, std::string>)
            text_choice(rows_, label, value, rest, field.rule, words(field));
        else if constexpr (std::is_same_v<V, int>)
            rows_.integer(label, value, rest, style, words(field));
        else if constexpr (std::is_same_v<V, glm::ivec3>)
            rows_.triple(label, value, rest, style, words(field),
                         {axis_of(field.rule, 0), axis_of(field.rule, 1), axis_of(field.rule, 2)});
        else if constexpr (std::is_same_v<V, glm::dvec3> || std::is_same_v<V, glm::vec3>) {
            const auto one = [&](int axis, ui::NumberStyle own, float width) {
                const auto other = [&](const T& each) {
                    return (each.*member)[axis] != (before_.*member)[axis];
                };
                own.words = std::ranges::any_of(all_, other) ? "mixed" : "";
                return axis_number(rows_.theme, label + own.axis, value[axis],
                                   shown_factor(field.rule.unit), own, width);
            };
            rows_.row( // fields beside each other have no room for the unit
                style.unit.empty() ? label : label + ", " + style.unit, value, rest,
                all_axes(words(field)),
                [&](float width) { return axis_fields(rows_.theme, width, style, one); }, true);
        } else if constexpr (std::is_same_v<V, glm::vec4>)
            rows_.row(label, value, rest, all_axes(words(field)), [&](float width) {
                return ui::color_field(rows_.theme, label, value, width);
            });
        else {
            const double factor = shown_factor(field.rule.unit);
            double shown = static_cast<double>(value) * factor;
            const double was = shown;
            rows_.number(label, shown, static_cast<double>(rest) * factor, style, words(field));
            if (shown != was) value = static_cast<V>(shown / factor);
        }
    }
    static RowWords all_axes(RowWords words)
    {
        if (!words.parameters.empty()) words.parameters = axes_of(words.parameters.front());
        return words;
    }
    template <class E>
    void choice(const std::string& label, E& value, E rest, std::vector<std::string> names,
                bool mixed, const RowWords& words)
    {
        if (mixed) names.insert(names.begin(), "mixed"); // is shown; to take it changes nothing
        const int first = mixed ? 1 : 0, shown = mixed ? 0 : static_cast<int>(value);
        rows_.choice(label, shown, static_cast<int>(rest) + first, names, words, [&](int chosen) {
            if (chosen != shown) value = static_cast<E>(chosen - first);
        });
    }
    ValueRows& rows_;
    T& value_;
    const T before_;
    std::string parameter_;
    std::vector<T> all_;
    std::vector<std::function<void(T&)>> taken_;
};

} // namespace trivar

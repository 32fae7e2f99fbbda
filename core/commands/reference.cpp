// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/every_command.h"
#include "core/commands/json_text.h"
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace trivar {
namespace {

template <class T> std::string type_name()
{
    if constexpr (std::is_same_v<T, bool>)
        return "true or false";
    else if constexpr (std::is_same_v<T, int>)
        return "whole number";
    else if constexpr (std::is_floating_point_v<T>)
        return "number";
    else if constexpr (std::is_same_v<T, std::string>)
        return "text";
    else if constexpr (std::is_enum_v<T>)
        return fmt::format("{}", fmt::join(choice_names<T>, ", "));
    else if constexpr (std::is_same_v<T, StrokeSample>)
        return "sample";
    else if constexpr (requires { FieldsOf<T>::told_as; })
        return std::string(FieldsOf<T>::told_as);
    else if constexpr (Nested<T>) // a shape
        return fmt::format("values of [{0}](#{0})", FieldsOf<T>::verb);
    else if constexpr (is_optional<T>)
        return type_name<typename T::value_type>();
    else if constexpr (std::is_same_v<T, std::vector<glm::dvec2>>)
        return "list of pairs of numbers";
    else if constexpr (is_list<T> && requires { T::value_type::length(); })
        return "list of lists of " + type_name<typename T::value_type>();
    else if constexpr (std::is_same_v<T, std::vector<std::vector<double>>>)
        return "list of lists of numbers";
    else if constexpr (is_list<T>)
        return "list of " + type_name<typename T::value_type>() + "s";
    else
        return fmt::format("{} {}s", T::length(), type_name<typename T::value_type>());
}

std::string range(const Rule& rule)
{
    const auto exact = [](double number) {
        return number_text(number, {.digits = 0, .commas = false});
    };
    const Rule free{};
    if (!rule.choices.empty()) {
        std::string text;
        for (const char c : rule.choices) text += c == '|' ? std::string(", ") : std::string(1, c);
        return text;
    }
    if (rule.works_to[2] > 0)
        return fmt::format("{} to {}, {} and {}", exact(rule.lo), rule.works_to[0],
                           rule.works_to[1], rule.works_to[2]);
    if (rule.works_to[0] > 0) return fmt::format("{} to {}", exact(rule.lo), rule.works_to[0]);
    if (rule.lo == free.lo && rule.hi == free.hi) return "";
    if (rule.hi != free.hi) return exact(rule.lo) + " to " + exact(rule.hi);
    return rule.lo == 0 ? "0 or more" : rule.lo < 1e-6 ? "above 0" : exact(rule.lo) + " or more";
}

// A FieldText describes a field. All three texts are made from it, so that only one function is
// compiled per type of field.
struct FieldText {
    std::string_view name, help;
    Rule rule;
    std::string type;
    std::string standard; // its default as JSON
    bool nested = false, optional = false;
    std::vector<FieldText> inside; // of a nested value
};

template <class T> std::vector<FieldText> fields_of(const T& value);

template <class V>
void tell(std::vector<FieldText>& fields, std::string_view name, const V& v, std::string_view help,
          const Rule& rule)
{
    FieldText& told = fields.emplace_back(
        FieldText{name, help, rule, type_name<V>(), "", Nested<V>, is_optional<V>, {}});
    if constexpr (Nested<V>)
        told.inside = fields_of(v);
    else if constexpr (!is_optional<V>)
        told.standard = value_json(v);
}

template <class T> std::vector<FieldText> fields_of(const T& value)
{
    std::vector<FieldText> fields;
    each_field(value, [&](std::string_view name, const auto& v, std::string_view help,
                          const Rule& rule = {}) { tell(fields, name, v, help, rule); });
    return fields;
}

std::string default_text(const FieldText& field)
{
    if (field.rule.required) return "required";
    if (field.nested) return "its own";
    return field.optional ? "nothing" : "`" + field.standard + "`";
}

std::string field_table(const std::vector<FieldText>& fields)
{
    std::string text = "| field | type | default | range | meaning |\n|---|---|---|---|---|\n";
    for (const FieldText& each : fields)
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", each.name, each.type,
                            default_text(each), range(each.rule), each.help);
    return text + "\n";
}

std::string fields_list(const std::vector<FieldText>& fields)
{
    std::string text;
    for (const FieldText& each : fields) {
        if (!text.empty()) text += ",";
        text += "{\"name\":" + json_text(each.name);
        if (each.nested)
            text += ",\"fields\":" + fields_list(each.inside);
        else {
            text += ",\"type\":" + json_text(each.type);
            if (!each.optional && !each.rule.required) text += ",\"default\":" + each.standard;
        }
        text += std::string(",\"required\":") + (each.rule.required ? "true" : "false");
        if (const std::string allowed = range(each.rule); !allowed.empty())
            text += ",\"range\":" + json_text(allowed);
        if (const std::string unit = unit_text(each.rule.unit); !unit.empty())
            text += ",\"unit\":" + json_text(unit);
        text += ",\"label\":" + json_text(label_of(each.name, each.rule));
        text += ",\"help\":" + json_text(each.help) + "}";
    }
    return "[" + text + "]";
}

// A ToldValue tells the fields of a type of values inside commands.
struct ToldValue {
    std::string_view title, about;
    std::vector<FieldText> fields;
};
template <class T> void add_told_in(std::vector<ToldValue>& to, const T& value);
template <class V> void add_told(std::vector<ToldValue>& to)
{
    if constexpr (is_optional<V> || is_list<V>)
        return add_told<typename V::value_type>(to);
    else if constexpr (Nested<V>) {
        if constexpr (requires { FieldsOf<V>::told_as; })
            if (const std::string_view link = FieldsOf<V>::told_as; link.starts_with('[')) {
                const std::string_view title = link.substr(1, link.find(']') - 1);
                if (std::ranges::find(to, title, &ToldValue::title) != to.end()) return;
                to.push_back({title, {}, fields_of(V{})});
                if constexpr (requires { FieldsOf<V>::about; })
                    to.back().about = FieldsOf<V>::about;
            }
        add_told_in(to, V{});
    }
}
template <class T> void add_told_in(std::vector<ToldValue>& to, const T& value)
{
    each_field(value, [&]<class V>(std::string_view, const V&, auto&&...) { add_told<V>(to); });
}

struct ToldCommand {
    std::string_view verb, summary;
    std::vector<FieldText> fields;
    void (*add_told)(std::vector<ToldValue>& to);
};

// Lists every command, in the order of the variant.
std::vector<ToldCommand> told_commands()
{
    const std::array all = EachOf<CommandKinds>::results([]<class C>() {
        return ToldCommand{C::verb, C::summary, fields_of(C{}),
                           [](std::vector<ToldValue>& to) { add_told_in(to, C{}); }};
    });
    return {all.begin(), all.end()};
}

} // namespace

std::string commands_text()
{
    std::string text;
    for (const ToldCommand& c : told_commands()) {
        text += fmt::format("{}\n    {}\n", c.verb, c.summary);
        for (const FieldText& each : c.fields)
            text += fmt::format("    {:<14} {}{}\n", each.name, each.help,
                                each.rule.required ? " (required)" : "");
    }
    return text;
}

std::string commands_markdown()
{
    std::string text =
        "# Commands\n\n"
        "Everything that can be done to a scene is one of these commands. A scene file holds one "
        "per line, as a JSON\nobject whose field `do` names the command; "
        "[document.md](document.md) "
        "explains the file. A field that is left\nout has its default. This page is written by "
        "`trivar commands --markdown`.\n\n"
        "| command | what it does |\n|---|---|\n";
    const std::vector<ToldCommand> commands = told_commands();
    for (const ToldCommand& c : commands)
        text += fmt::format("| [{}](#{}) | {} |\n", c.verb, c.verb, c.summary);
    text += "\n";
    for (const ToldCommand& c : commands)
        text += fmt::format("## {}\n\n{}\n\n", c.verb, c.summary) + field_table(c.fields);
    text += "# Values inside commands\n\nA sample is a list `[x px, y px, seconds, pressure]`; "
            "pressure and seconds may be left out.\n\n";
    std::vector<ToldValue> sections;
    for (const ToldCommand& c : commands) c.add_told(sections);
    for (const ToldValue& each : sections)
        text += fmt::format("## {}\n\n{}", each.title, each.about) +
                (each.about.empty() ? "" : "\n\n") + field_table(each.fields);
    text.pop_back();
    return text;
}

std::string commands_json()
{
    std::string text;
    for (const ToldCommand& c : told_commands()) {
        if (!text.empty()) text += ",\n";
        text += "{\"do\":" + json_text(c.verb) + ",\"summary\":" + json_text(c.summary) +
                ",\"fields\":" + fields_list(c.fields) + "}";
    }
    return "[" + text + "]\n";
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/words/number_words.h"

#include "core/commands/words/changes.h"
#include "core/document/fields/object_fields.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <vector>

namespace trivar {
namespace {

// Rules has the rule of each field by its name as a parameter, with # in place of numbers.
using Rules = std::map<std::string, Rule, std::less<>>;

template <class T> void add_rules(Rules& rules, const std::string& name, const Rule& rule)
{
    if (!name.empty()) rules.emplace(name, rule);
    if constexpr (Nested<T>) {
        const T value{};
        each_field(value, [&]<class V>(std::string_view inner, const V&, std::string_view,
                                       const Rule& inner_rule = {}) {
            const std::string prefix = name.empty() || inner_rule.inlined ? name : name + ".";
            add_rules<V>(rules, inner_rule.inlined ? name : prefix + std::string(inner),
                         inner_rule.inlined ? rule : inner_rule);
        });
    } else if constexpr (is_optional<T> || is_list<T>)
        add_rules<typename T::value_type>(rules, is_list<T> ? name + ".#" : name, rule);
    else if constexpr (is_ref<T>)
        add_rules<std::remove_const_t<typename T::element_type>>(rules, name, rule);
    else if constexpr (is_choice<T>)
        [&]<class... One>(const std::variant<One...>*) {
            (add_rules<One>(rules, name, rule), ...);
        }(static_cast<const T*>(nullptr));
}

const Rules& all_rules()
{
    static const Rules rules = [] {
        Rules out;
        add_rules<Object>(out, "", {});
        add_rules<RenderSettings>(out, "render", {});
        add_rules<Camera>(out, "camera", {});
        return out;
    }();
    return rules;
}

std::vector<std::string> parts_of(const std::string& parameter)
{
    std::vector<std::string> parts{""};
    for (const char c : parameter)
        if (c == '.')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

bool is_count(const std::string& part)
{
    constexpr std::size_t most = 6; // digits; names of views may have more
    return !part.empty() && part.size() <= most &&
           std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Returns the component of a vector that the last part of a name means; -1 if none.
int component_of(const std::string& part)
{
    return part.size() == 1 ? static_cast<int>(std::string_view("xyzw").find(part)) : -1;
}

} // namespace

NumberWords words_of_number(const std::string& parameter)
{
    const std::vector<std::string> parts = parts_of(parameter);
    std::size_t last = parts.size() - 1;
    const int component = last > 0 ? component_of(parts[last]) : -1;
    if (component >= 0) --last;
    const bool camera = parts[0] == "camera"; // followed by a name, which may be any
    // The words that its panel shows already are left out.
    const std::size_t first = parts.size() > 1 && parts[0] != "shaping" ? 1 : 0;
    NumberWords out;
    Rule rule;
    std::string pattern = parts[0];
    for (std::size_t i = 0; i <= last; ++i) {
        const bool numbered = is_count(parts[i]) && !camera;
        if (i > 0) pattern += numbered ? ".#" : "." + parts[i];
        const auto known = all_rules().find(camera && i == last ? "camera." + parts[i] : pattern);
        rule = known == all_rules().end() ? Rule{} : known->second;
        if (i < first) continue;
        std::string word =
            numbered ? std::to_string(std::stol(parts[i]) + 1) : label_of(parts[i], rule);
        if (camera && i == 1 && parts[i] == "picture") word = "Render camera";
        if (i > first && !word.empty())
            word[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(word[0])));
        out.label += (out.label.empty() ? "" : " ") + word;
    }
    if (component >= 0) out.label += " " + axis_of(rule, component);
    if (!out.label.empty())
        out.label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out.label[0])));
    out.unit = unit_text(rule.unit);
    out.factor = shown_factor(rule.unit);
    return out;
}

std::string words_of_value(const Parameter& parameter, double value)
{
    using Kind = Parameter::Kind;
    if (parameter.kind == Kind::on_off)
        return std::string(value >= 0.5 ? parameter.yes : parameter.no);
    if (parameter.kind == Kind::choice) {
        const double most = static_cast<double>(parameter.choices.size()) - 1;
        const auto chosen = static_cast<std::size_t>(std::clamp(std::round(value), 0.0, most));
        return in_words(parameter.choices[chosen]);
    }
    return with_unit(value, parameter.unit);
}

} // namespace trivar

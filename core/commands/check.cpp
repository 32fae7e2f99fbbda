// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/commands/command.h"
#include "core/commands/every_command.h"
#include "core/document/field.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// Largest length of a text and a list, far beyond any name, path or stroke; it keeps hostile lines
// from using much memory.
constexpr std::size_t longest_text = 4096;
constexpr std::size_t longest_list = 100000;

void check_number(std::string_view name, double value, const Rule& rule)
{
    if (value >= rule.lo && value <= rule.hi) return; // NaN is neither
    const auto exact = [](double number) { return number_text(number, {.digits = 0}); };
    if (rule.hi == Rule{}.hi && value < rule.lo)
        throw Rejected(
            fmt::format("field \"{}\" is {} but must be {}", name, exact(value),
                        rule.lo > 0 && value <= 0 ? "above 0" : "at least " + exact(rule.lo)));
    throw Rejected(fmt::format("field \"{}\" is {} but must lie between {} and {}", name,
                               exact(value), exact(rule.lo), exact(rule.hi)));
}

void check_text(std::string_view name, std::string_view text, const Rule& rule)
{
    if (text.size() > longest_text)
        throw Rejected(fmt::format("field \"{}\" has {} bytes but at most {} are allowed", name,
                                   with_commas(text.size()), with_commas(longest_text)));
    if (!is_utf8(text)) throw Rejected(fmt::format("field \"{}\" is not UTF-8 text", name));
    if (text.find('\0') != text.npos)
        throw Rejected(fmt::format(
            "field \"{}\" holds the control character U+0000, which is not allowed in text", name));
    if (rule.choices.empty()) return;
    const std::string all = "|" + std::string(rule.choices) + "|";
    if (text.find('|') != text.npos || all.find("|" + std::string(text) + "|") == all.npos)
        throw Rejected(fmt::format("field \"{}\" is \"{}\" but must be one of {}", name,
                                   excerpt(text), rule.choices));
}

template <class T> void check_value(const std::string& name, const T& value, const Rule& rule)
{
    if constexpr (Nested<T>)
        each_field(value, [&](std::string_view inner, const auto& v, std::string_view,
                              Rule inner_rule = {}) {
            check_value(name + "." + std::string(inner), v, inner_rule);
        });
    else if constexpr (std::is_same_v<T, bool>)
        return;
    else if constexpr (std::is_arithmetic_v<T>)
        check_number(name, static_cast<double>(value), rule);
    else if constexpr (std::is_enum_v<T>) {
        if (static_cast<std::size_t>(value) >= choice_names<T>.size())
            throw Rejected(fmt::format("field \"{}\" is not one of its choices", name));
    } else if constexpr (std::is_same_v<T, std::string>)
        check_text(name, value, rule);
    else if constexpr (std::is_same_v<T, StrokeSample>) {
        check_value(name, value.p_px, rule);
        check_number(name, value.time_s, rule);
        check_number(name, value.pressure, in_range(0, 1));
    } else if constexpr (is_optional<T>) {
        if (value) check_value(name, *value, rule);
    } else if constexpr (is_list<T>) {
        if (value.size() > longest_list)
            throw Rejected(fmt::format("field \"{}\" has {} entries but at most {} are allowed",
                                       name, with_commas(value.size()), with_commas(longest_list)));
        for (std::size_t i = 0; i < value.size(); ++i)
            check_value(fmt::format("{}[{}]", name, i), value[i], rule);
    } else
        for (int i = 0; i < T::length(); ++i)
            check_number(fmt::format("{}[{}]", name, i), static_cast<double>(value[i]), rule);
}

} // namespace

void check(const Command& command)
{
    visit(
        [](const auto& c) {
            each_field(c, [](std::string_view name, const auto& value, std::string_view,
                             Rule rule = {}) { check_value(std::string(name), value, rule); });
        },
        command);
}

} // namespace trivar

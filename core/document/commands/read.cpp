// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/commands/read_json.h"

#include "core/base/rejected.h"
#include "core/document/command.h"

#include <fmt/format.h>
#include <limits>
#include <set>

namespace trivar {
namespace {

using nlohmann::json;

[[noreturn]] void reject(const std::string& name, std::string_view wanted, const json& found)
{
    std::string text = found.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > 40) text = std::string(found.type_name());
    throw Rejected(fmt::format("field \"{}\" must be {}, not {}", name, wanted, text));
}

template <class T>
void read_fields(const std::string& prefix, const json& object, T& value,
                 std::string_view also_known = "");

template <class T> void read_value(const std::string& name, const json& from, T& value)
{
    if constexpr (Nested<T>) {
        if (!from.is_object()) reject(name, "an object in braces", from);
        read_fields(name + ".", from, value);
    } else if constexpr (std::is_same_v<T, bool>) {
        if (!from.is_boolean()) reject(name, "true or false", from);
        value = from.get<bool>();
    } else if constexpr (std::is_same_v<T, int>) {
        // Whole numbers beyond 64 bits have become doubles here.
        const bool whole = from.is_number_integer() &&
                           (from.is_number_unsigned()
                                ? from.get<std::uint64_t>() <= std::numeric_limits<int>::max()
                                : from.get<std::int64_t>() >= std::numeric_limits<int>::min() &&
                                      from.get<std::int64_t>() <= std::numeric_limits<int>::max());
        if (!whole) reject(name, "a whole number", from);
        value = from.get<int>();
    } else if constexpr (std::is_floating_point_v<T>) {
        if (!from.is_number()) reject(name, "a number", from);
        const auto wide = from.get<double>();
        if (!(std::abs(wide) <= std::numeric_limits<T>::max())) reject(name, "smaller", from);
        value = static_cast<T>(wide);
    } else if constexpr (std::is_enum_v<T>) {
        for (std::size_t i = 0; i < choice_names<T>.size(); ++i)
            if (from == choice_names<T>[i]) {
                value = static_cast<T>(i);
                return;
            }
        reject(name, fmt::format("one of {}", fmt::join(choice_names<T>, ", ")), from);
    } else if constexpr (std::is_same_v<T, std::string>) {
        if (!from.is_string()) reject(name, "a text in quotes", from);
        value = from.get<std::string>();
    } else if constexpr (std::is_same_v<T, StrokeSample>) {
        if (!from.is_array() || from.size() < 2 || from.size() > 4)
            reject(name, "[x px, y px, seconds, pressure]", from);
        read_value(name + "[0]", from[0], value.p_px.x);
        read_value(name + "[1]", from[1], value.p_px.y);
        if (from.size() > 2) read_value(name + "[2]", from[2], value.time_s);
        if (from.size() > 3) read_value(name + "[3]", from[3], value.pressure);
    } else if constexpr (is_optional<T>)
        read_value(name, from, value.emplace());
    else if constexpr (is_list<T>) {
        if (!from.is_array()) reject(name, "a list in brackets", from);
        value.clear();
        for (std::size_t i = 0; i < from.size(); ++i)
            read_value(fmt::format("{}[{}]", name, i), from[i], value.emplace_back());
    } else {
        if (!from.is_array() || from.size() != static_cast<std::size_t>(T::length()))
            reject(name, fmt::format("a list of {} numbers", T::length()), from);
        for (int i = 0; i < T::length(); ++i)
            read_value(fmt::format("{}[{}]", name, i), from[static_cast<std::size_t>(i)], value[i]);
    }
}

template <class T>
void read_fields(const std::string& prefix, const json& object, T& value,
                 std::string_view also_known)
{
    std::set<std::string, std::less<>> known{std::string(also_known)};
    each_field(value, [&](std::string_view name, auto& v, std::string_view, Rule rule = {}) {
        known.emplace(name);
        const auto found = object.find(name);
        if (found != object.end())
            read_value(prefix + std::string(name), *found, v);
        else if (rule.required)
            throw Rejected(fmt::format("field \"{}{}\" is missing", prefix, name));
    });
    for (const auto& [name, ignored] : object.items())
        if (!known.contains(name))
            throw Rejected(fmt::format("field \"{}{}\" is unknown here", prefix, name));
}

template <std::size_t I = 0> Command command_named(std::string_view verb, const json& object)
{
    if constexpr (I == std::variant_size_v<Command>)
        throw Rejected(fmt::format("there is no command \"{}\"; trivar commands lists them", verb));
    else {
        using C = std::variant_alternative_t<I, Command>;
        if (verb != C::verb) return command_named<I + 1>(verb, object);
        C command;
        read_fields("", object, command, "do");
        return command;
    }
}

} // namespace

json parse_object(std::string_view line)
{
    std::vector<std::set<std::string>> keys;
    constexpr int deepest = 8; // no field nests further, and some walks over JSON are recursive
    const auto watch = [&](int depth, json::parse_event_t event, json& parsed) {
        if (depth > deepest) throw Rejected("brackets nest too deeply");
        if (event == json::parse_event_t::object_start) keys.emplace_back();
        if (event == json::parse_event_t::object_end) keys.pop_back();
        if (event == json::parse_event_t::key &&
            !keys.back().insert(parsed.get_ref<const std::string&>()).second)
            throw Rejected(fmt::format("field \"{}\" appears twice", parsed.get<std::string>()));
        return true;
    };
    try {
        json object = json::parse(line, watch);
        if (!object.is_object()) throw Rejected("the line must be an object in braces");
        return object;
    } catch (const json::parse_error& error) {
        throw Rejected(fmt::format("no JSON: byte {} is not what it should be", error.byte));
    } catch (const json::exception&) {
        throw Rejected("no JSON: a number is too large");
    }
}

std::string text_field(const json& object, const std::string& name)
{
    std::string text;
    read_value(name, object.at(name), text);
    return text;
}

Command command_from(const json& object)
{
    if (!object.contains("do")) throw Rejected("field \"do\", the command's name, is missing");
    return command_named(text_field(object, "do"), object);
}

Command command_from_json_line(std::string_view line)
{
    return command_from(parse_object(line));
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/read_json.h"
#include "core/document/field.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/every_command.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <utility>

namespace trivar {
namespace {

using nlohmann::json;

[[noreturn]] void reject(const std::string& name, std::string_view wanted, const json& found)
{
    std::string text = found.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > 40) text = std::string(found.type_name());
    throw Rejected(fmt::format("field \"{}\" must be {}, not {}", name, wanted, printable(text)));
}

// These functions do not depend on the type of a field, because there are some 150 fields, and the
// code of each calls them.

std::string element(const std::string& name, std::size_t i)
{
    return fmt::format("{}[{}]", name, i);
}

void read_value(const std::string& name, const json& from, bool& value)
{
    if (!from.is_boolean()) reject(name, "true or false", from);
    value = from.get<bool>();
}

void read_value(const std::string& name, const json& from, int& value)
{
    // Whole numbers beyond 64 bits have become doubles here.
    constexpr auto most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
    const bool whole = from.is_number_unsigned()
                           ? from.get<std::uint64_t>() <= most
                           : from.is_number_integer() && from.get<std::int64_t>() >= least &&
                                 from.get<std::int64_t>() <= most;
    if (!whole)
        reject(name, from.is_number_integer() ? "a smaller whole number" : "a whole number", from);
    value = from.get<int>();
}

double number(const std::string& name, const json& from, double largest)
{
    if (!from.is_number()) reject(name, "a number", from);
    const auto value = from.get<double>();
    if (!(std::abs(value) <= largest)) reject(name, "smaller", from);
    return value;
}
void read_value(const std::string& name, const json& from, double& value)
{
    value = number(name, from, std::numeric_limits<double>::max());
}
void read_value(const std::string& name, const json& from, float& value)
{
    value = static_cast<float>(number(name, from, std::numeric_limits<float>::max()));
}

void read_value(const std::string& name, const json& from, std::string& value)
{
    if (!from.is_string()) reject(name, "a text in quotes", from);
    value = from.get<std::string>();
}

void read_value(const std::string& name, const json& from, StrokeSample& value)
{
    if (!from.is_array() || from.size() < 2 || from.size() > 4)
        reject(name, "[x px, y px, seconds, pressure]", from);
    read_value(element(name, 0), from[0], value.p_px.x);
    read_value(element(name, 1), from[1], value.p_px.y);
    if (from.size() > 2) read_value(element(name, 2), from[2], value.time_s);
    if (from.size() > 3) read_value(element(name, 3), from[3], value.pressure);
}

std::size_t choice(const std::string& name, const json& from,
                   std::span<const std::string_view> choices)
{
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (from == choices[i]) return i;
    reject(name, fmt::format("one of {}", fmt::join(choices, ", ")), from);
}

void check_list(const std::string& name, const json& from)
{
    if (!from.is_array()) reject(name, "a list in brackets", from);
}
void check_numbers(const std::string& name, const json& from, std::size_t count)
{
    if (!from.is_array() || from.size() != count)
        reject(name, fmt::format("a list of {} numbers", count), from);
}

// A Fields reads the fields of one object in braces; a field that is not read is an error.
class Fields {
public:
    Fields(const json& object, std::string prefix, std::string_view also_known = "")
        : object_(&object),
          prefix_(std::move(prefix)),
          known_{also_known}
    {
    }
    // Reads a field. A field that is left out leaves the value unchanged.
    void read(std::string_view name, bool required, void* value,
              void (*reader)(const std::string& name, const json& from, void* value))
    {
        if (const json* found = take(name, required))
            reader(prefix_ + std::string(name), *found, value);
    }
    void check_all_taken() const
    {
        for (const auto& [name, ignored] : object_->items())
            if (std::find(known_.begin(), known_.end(), name) == known_.end())
                throw Rejected(
                    fmt::format("field \"{}{}\" is unknown here", prefix_, excerpt(name)));
    }

private:
    const json* take(std::string_view name, bool required)
    {
        known_.push_back(name);
        const auto found = object_->find(name);
        if (found != object_->end()) return &*found;
        if (required) throw Rejected(fmt::format("field \"{}{}\" is missing", prefix_, name));
        return nullptr;
    }

    const json* object_;
    std::string prefix_;
    std::vector<std::string_view> known_;
};

Fields nested(const std::string& name, const json& from)
{
    if (!from.is_object()) reject(name, "an object in braces", from);
    return {from, name + "."};
}

template <class T> void read_fields(Fields from, T& value);

template <class T> void read_value(const std::string& name, const json& from, T& value)
{
    if constexpr (Nested<T>)
        read_fields(nested(name, from), value);
    else if constexpr (std::is_enum_v<T>) {
        const bool old = was_switch<T> && from.is_boolean();
        value = static_cast<T>(old ? from.get<bool>() : choice(name, from, choice_names<T>));
    } else if constexpr (is_optional<T>)
        read_value(name, from, value.emplace());
    else if constexpr (is_list<T>) {
        check_list(name, from);
        value.clear();
        for (std::size_t i = 0; i < from.size(); ++i)
            read_value(element(name, i), from[i], value.emplace_back());
    } else {
        constexpr auto count = static_cast<std::size_t>(T::length());
        check_numbers(name, from, count);
        for (std::size_t i = 0; i < count; ++i)
            read_value(element(name, i), from[i], value[static_cast<int>(i)]);
    }
}

template <class T> void read_any(const std::string& name, const json& from, void* value)
{
    read_value(name, from, *static_cast<T*>(value));
}

template <class T> void read_fields(Fields from, T& value)
{
    each_field(value,
               [&]<class V>(std::string_view name, V& v, std::string_view, const Rule& rule = {}) {
                   from.read(name, rule.required, &v, read_any<V>);
               });
    from.check_all_taken();
}

template <class C> Command command_of(const json& object)
{
    C command;
    read_fields(Fields(object, "", "do"), command);
    return command;
}

Command command_named(std::string_view verb, const json& object)
{
    struct NamedCommand {
        std::string_view verb;
        Command (*read)(const json& object);
    };
    static const std::array all = EachOf<CommandKinds>::results([]<class C>() {
        return NamedCommand{C::verb, command_of<C>};
    });
    for (const NamedCommand& each : all)
        if (each.verb == verb) return each.read(object);
    throw Rejected(
        fmt::format("there is no command \"{}\"; trivar commands lists them", excerpt(verb)));
}

} // namespace

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

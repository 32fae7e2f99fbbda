// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/typed_command.h"

#include "core/base/text.h"
#include "editor/commands/as_it_is.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using json = nlohmann::ordered_json;

constexpr std::string_view blank = " \t\r\n";

// Takes a value off the front: brackets, braces and quotes to their end, else up to a blank.
std::string_view take_value(std::string_view& rest)
{
    constexpr int deepest = 8; // more brackets could exhaust the stack
    int depth = 0;
    bool quoted = false;
    std::size_t i = 0;
    for (; i < rest.size(); ++i) {
        const char c = rest[i];
        if (quoted) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                quoted = false;
            continue;
        }
        if (depth == 0 && blank.find(c) != blank.npos) break;
        if (c == '"') quoted = true;
        if ((c == '[' || c == '{') && ++depth > deepest)
            throw Rejected("Brackets nest too deeply.");
        if (c == ']' || c == '}') --depth;
    }
    const std::string_view value = rest.substr(0, std::min(i, rest.size()));
    rest.remove_prefix(value.size());
    return value;
}

json value_of(std::string_view text, std::string_view field)
{
    json value = json::parse(text, nullptr, false);
    if (!value.is_discarded()) return value;
    if (text.find_first_of("[]{}\"") == text.npos) return std::string(text); // a bare word
    throw Rejected(fmt::format("The value of \"{}\" is not closed or holds a word without quotes: "
                               "{}",
                               printable(field), printable(text)));
}

Id id_of(const std::string& name, const Document& document)
{
    Id found = 0;
    for (const auto& [id, each] : document.objects) {
        if (each->name != name) continue;
        if (found != 0)
            throw Rejected(fmt::format("Two objects are called {}; write the number, {} or {}.",
                                       printable(name), found, id));
        found = id;
    }
    if (found == 0) throw Rejected(fmt::format("No object is called {}.", printable(name)));
    return found;
}

// Names to numbers, and one object to a list of one where the field takes several.
void resolve_objects(json& value, std::string_view field, const Document& document)
{
    if (names_objects(field) && !value.is_array()) value = json::array({value});
    const auto resolve = [&](json& one) {
        if (one.is_string()) one = id_of(one.get<std::string>(), document);
    };
    if (!value.is_array()) return resolve(value);
    for (json& one : value) resolve(one);
}

// The place of "parameters.width" in the object.
json& place_of(json& object, std::string_view field)
{
    json* at = &object;
    for (std::size_t dot = field.find('.'); dot != field.npos; dot = field.find('.')) {
        at = &(*at)[std::string(field.substr(0, dot))];
        if (!at->is_null() && !at->is_object())
            throw Rejected(fmt::format("\"{}\" is given as a whole already.",
                                       printable(field.substr(0, dot))));
        field.remove_prefix(dot + 1);
    }
    return (*at)[std::string(field)];
}

// Returns the values of a command without the objects that it is about.
json values_of(const Command& command)
{
    json values = json::parse(to_json_line(command));
    for (const char* field : {"do", "object", "objects"}) values.erase(field);
    return values;
}

Command default_of(std::string_view name)
{
    for (Command& each : every_command())
        if (verb(each) == name) return std::move(each);
    throw Rejected(fmt::format("There is no command \"{}\". Tab lists them.", printable(name)));
}

// Returns the values that are not typed and stay as they are; empty for commands that make
// something new.
json present_values(const json& typed, const Document& document)
{
    const json& ids = typed.contains("object")    ? typed["object"]
                      : typed.contains("objects") ? typed["objects"]
                                                  : json();
    const json& id = ids.is_array() && !ids.empty() ? ids.front() : ids;
    const auto same = as_it_is(default_of(typed["do"].get<std::string>()),
                               id.is_number_integer() ? id.get<Id>() : 0, document);
    return same ? values_of(*same) : json::object();
}

void add_missing(json& to, const json& from)
{
    for (const auto& [field, value] : from.items())
        if (!to.contains(field))
            to[field] = value;
        else if (to[field].is_object() && value.is_object())
            add_missing(to[field], value);
}

void put(json& object, std::string_view field, json value, const Document& document)
{
    if (names_object(field) || names_objects(field)) resolve_objects(value, field, document);
    json& place = place_of(object, field);
    if (!place.is_null()) throw Rejected(fmt::format("\"{}\" is given twice.", printable(field)));
    place = std::move(value);
}

Command command_with(const json& object)
{
    return command_from_json_line(object.dump(-1, ' ', false, json::error_handler_t::replace));
}

Command typed_fields(std::string_view text, const Document& document)
{
    const std::string_view name = take_value(text);
    json object{{"do", std::string(verb(default_of(name)))}};
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
        if (text.empty()) break;
        const std::size_t equals = text.find('=');
        const std::string_view field = text.substr(0, equals);
        if (equals == text.npos || field.empty() || field.find_first_of(blank) != field.npos)
            throw Rejected(
                fmt::format("Write field=value after {}, for example name=Snake.", name));
        text.remove_prefix(equals + 1);
        const std::string_view value_text = take_value(text);
        if (value_text.empty())
            throw Rejected(fmt::format("\"{}\" has no value.", printable(field)));
        put(object, field, value_of(value_text, field), document);
    }
    add_missing(object, present_values(object, document));
    return command_with(object);
}

template <class What> LogLine line_of(What what)
{
    LogLine line;
    line.what = std::move(what);
    return line;
}

} // namespace

bool names_object(std::string_view field)
{
    return field == "object" || field == "around" || field == "parent" || field == "before";
}
bool names_objects(std::string_view field)
{
    return field == "objects" || field == "onto";
}

LogLine typed_line(std::string_view text, const Document& document)
{
    text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
    text.remove_suffix(text.size() - std::min(text.find_last_not_of(blank) + 1, text.size()));
    if (text.empty()) throw Rejected("Type a command first; Tab lists them.");
    if (text == "undo" || text == "{\"undo\":true}") return line_of(UndoLine{});
    if (text == "redo" || text == "{\"redo\":true}") return line_of(RedoLine{});
    if (text.front() == '{') { // as it stands in a scene
        LogLine line = read_log_line(text);
        if (!std::holds_alternative<CheckLine>(line.what)) return line;
        throw Rejected("The line holds a digest and no command.");
    }
    return line_of(typed_fields(text, document));
}

Command typed_values(const Command& otherwise, const std::vector<TypedValue>& values,
                     const Document& document)
{
    json object{{"do", std::string(verb(otherwise))}};
    for (const auto& [field, value] : values)
        if (names_object(field) || names_objects(field))
            put(object, field, value_of(value, field), document);
    const bool others = object.contains("object") || object.contains("objects");
    for (const auto& [field, value] : values)
        if (!names_object(field) && !names_objects(field))
            put(object, field, value_of(value, field), document);
    json stays = json::parse(to_json_line(otherwise));
    if (others) { // of which other values are what stays
        const json own = present_values(stays, document);
        add_missing(object, present_values(object, document));
        if (!own.empty() && own == values_of(otherwise))
            stays = json::parse(to_json_line(default_of(verb(otherwise))));
    }
    add_missing(object, stays);
    return command_with(object);
}

std::string typed_text(const Command& command, const Document& document)
{
    const json object = json::parse(to_json_line(command));
    const auto named = [&](const json& id) -> json {
        const auto found = document.objects.find(id.get<Id>());
        if (found == document.objects.end()) return id;
        const auto same = [&](const auto& each) {
            return each.second->name == found->second->name;
        };
        if (std::ranges::count_if(document.objects, same) > 1) return id;
        return found->second->name;
    };
    std::string text(verb(command));
    for (const auto& [field, value] : object.items()) {
        if (field == "do") continue;
        json shown = value;
        if (names_object(field)) shown = named(value);
        if (names_objects(field) && value.is_array())
            for (json& one : shown) one = named(one);
        text += fmt::format(" {}={}", field,
                            shown.dump(-1, ' ', false, json::error_handler_t::replace));
    }
    return text;
}

} // namespace trivar

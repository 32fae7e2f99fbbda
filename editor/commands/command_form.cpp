// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/command_form.h"

#include "core/base/expression.h"
#include "core/base/text.h"
#include "core/commands/placement/place.h"
#include "editor/commands/typed_command.h"
#include "editor/words/field_words.h"
#include "editor/words/ranked.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using json = nlohmann::ordered_json;
using Field = CommandForm::Field;

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    text.remove_suffix(text.size() - std::min(text.find_last_not_of(blanks) + 1, text.size()));
    return text;
}

std::string dumped(const json& value)
{
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

// Cut at the separators outside of quotes, brackets and parentheses.
std::vector<std::string_view> cut_at(std::string_view text, std::string_view separators)
{
    std::vector<std::string_view> parts;
    int depth = 0;
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\')
            ++i;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '(' || c == '['))
            ++depth;
        else if (!quoted && (c == ')' || c == ']'))
            --depth;
        else if (!quoted && depth <= 0 && separators.find(c) != separators.npos) {
            parts.push_back(trimmed(text.substr(begin, i - begin)));
            begin = i + 1;
        }
    }
    parts.push_back(trimmed(text.substr(begin)));
    return parts;
}

// "1, 2, 3", "1 2 3" or "12 mm 5 mm 0": what is between them.
std::vector<std::string> numbers_in(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('[') && text.ends_with(']'))
        text = trimmed(text.substr(1, text.size() - 2));
    const auto by_commas = cut_at(text, ",");
    std::vector<std::string> numbers;
    if (by_commas.size() > 1) {
        for (const std::string_view each : by_commas) numbers.emplace_back(each);
        return numbers;
    }
    constexpr std::array<std::string_view, 8> units{"mm", "cm", "m",   "km",
                                                    "in", "ft", "deg", "rad"};
    for (const std::string_view each : cut_at(text, blanks)) {
        if (each.empty()) continue;
        if (!numbers.empty() && std::ranges::find(units, each) != units.end())
            numbers.back() += " " + std::string(each);
        else
            numbers.emplace_back(each);
    }
    return numbers;
}

json number_json(const Field& field, std::string_view text, std::string_view present)
{
    const Measure measure = field.unit == "m"     ? Measure::length
                            : field.unit == "deg" ? Measure::angle
                                                  : Measure::plain;
    const auto value = evaluate_expression(text, measure, parse_number(present).value_or(0));
    if (!value) return std::string(text); // which is refused by the field's name
    return json::parse(shortest(*value));
}

std::size_t count_called(const Document& document, std::string_view name)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        document.objects, [&](const auto& each) { return each.second->name == name; }));
}
bool is_called(const Document& document, std::string_view name)
{
    return count_called(document, name) > 0;
}

bool is_number(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos && text.size() < 10;
}

// A name as it stands, in quotes, or the number of the object.
json object_json(std::string_view text, const Document& document)
{
    if (is_called(document, text)) return std::string(text);
    if (is_number(text)) return json::parse(text);
    if (text.starts_with('"')) {
        json quoted = json::parse(text, nullptr, false);
        if (quoted.is_string()) return quoted;
    }
    return std::string(text);
}

// "200 300, 400 320": a list of lists of numbers; as JSON has it, it may be given too.
json points_json(const Field& field, std::string_view typed)
{
    if (typed == "none") return json::array();
    if (typed.starts_with('[')) {
        json list = json::parse(typed, nullptr, false);
        if (list.is_array()) return list;
    }
    json points = json::array();
    for (const std::string_view each : cut_at(typed, ",;")) {
        if (each.empty()) continue;
        json numbers = json::array();
        for (const std::string& number : numbers_in(each))
            numbers.push_back(number_json(field, number, "0"));
        points.push_back(std::move(numbers));
    }
    return points;
}

std::string value_json(const Field& field, const Document& document)
{
    const std::string_view typed = trimmed(field.typed);
    if (field.kind == Field::object) return dumped(object_json(typed, document));
    if (field.kind == Field::objects) {
        json several = json::array();
        if (is_called(document, typed)) return dumped(json::array({std::string(typed)}));
        for (const std::string_view each : cut_at(typed, ","))
            if (!each.empty()) several.push_back(object_json(each, document));
        return dumped(several);
    }
    if (field.kind == Field::choice) // true and false are no texts
        return typed == "true" || typed == "false" ? std::string(typed)
                                                   : dumped(std::string(typed));
    if (field.kind == Field::number && !field.list)
        return dumped(number_json(field, typed, field.present));
    if (field.kind == Field::number) {
        const auto was = numbers_in(field.present);
        const auto texts = numbers_in(typed);
        json numbers = json::array();
        for (std::size_t i = 0; i < texts.size(); ++i)
            numbers.push_back(number_json(field, texts[i], i < was.size() ? was[i] : "0"));
        return dumped(numbers);
    }
    if (field.kind == Field::points) return dumped(points_json(field, typed));
    if (typed.starts_with('"')) {
        const json quoted = json::parse(typed, nullptr, false);
        if (quoted.is_string()) return dumped(quoted);
    }
    return dumped(std::string(typed));
}

// A name that means one object, else its number; in quotes where it would be read as more.
std::string typed_name(Id id, const std::string& name, std::size_t count, bool among_others)
{
    if (name.empty() || count > 1) return std::to_string(id);
    const bool odd = trimmed(name) != name || name.starts_with('"') ||
                     (among_others && name.find_first_of(",\"([") != name.npos) ||
                     printable(name) != name;
    return odd ? dumped(name) : name;
}

// Where the points are, as far as they are few; of samples no more than that.
std::string points_text(const json& points, bool samples)
{
    constexpr std::size_t most = 4;
    if (points.empty()) return "none";
    if (points.size() > most) return std::to_string(points.size()) + " points";
    std::string text;
    for (const json& each : points) {
        text += text.empty() ? "" : ", ";
        for (std::size_t i = 0; i < (samples ? 2 : each.size()); ++i)
            text += (i > 0 ? " " : "") + dumped(each[i]);
    }
    return text;
}

std::string present_text(const Field& field, const json& value, const Document& document)
{
    const auto name = [&](const json& id, bool among_others) -> std::string {
        const Id number = id.get<Id>();
        if (!document.objects.contains(number))
            return number == 0 ? "none" : std::to_string(number);
        const std::string& called = object(document, number).name;
        return typed_name(number, called, count_called(document, called), among_others);
    };
    if (value.is_null()) return "as it is";
    if (field.kind == Field::points) return points_text(value, field.name.ends_with("samples"));
    if (field.kind == Field::object) return name(value, false);
    std::string text;
    if (value.is_array()) {
        for (const json& each : value)
            text += (text.empty()                   ? ""
                     : field.kind == Field::objects ? ", "
                                                    : " ") +
                    (field.kind == Field::objects ? name(each, true) : dumped(each));
        return text.empty() ? "none" : text;
    }
    return value.is_string() ? printable(value.get<std::string>()) : dumped(value);
}

std::vector<std::string> choices_in(std::string_view choices)
{
    std::vector<std::string> words;
    for (const std::string_view each : cut_at(choices, ",")) words.emplace_back(each);
    return words;
}

// Adds the fields of a list that `commands_json` wrote. False: one that is needed cannot be typed.
bool add_fields(std::vector<Field>& fields, const json& list, const std::string& prefix)
{
    for (const json& each : list) {
        const auto last = each["name"].get<std::string>();
        const std::string name = prefix + last;
        if (each.contains("fields")) {
            if (!add_fields(fields, each["fields"], name + ".")) return false;
            continue;
        }
        const auto type = each["type"].get<std::string>(), help = each["help"].get<std::string>();
        const std::string range = each.value("range", "");
        Field field{name, each["label"].get<std::string>(), each.value("unit", ""), help};
        const bool several = type.ends_with("numbers");
        if (names_object(name) || names_objects(name))
            field.kind = names_object(name) ? Field::object : Field::objects;
        else if (type == "true or false")
            field.choices = {"true", "false"};
        else if (type.ends_with("number") || (several && !type.starts_with("list")))
            field.kind = Field::number;
        else if (type == "text")
            field.choices = range.empty() ? std::vector<std::string>{} : choices_in(range);
        else if (type == "list of pairs of numbers" || type == "list of lists of numbers" ||
                 type == "list of samples")
            field.kind = Field::points;
        else if (type.find(", ") != type.npos)
            field.choices = choices_in(type);
        else if (each["required"].get<bool>())
            return false;
        else
            continue;
        if (!field.choices.empty()) field.kind = Field::choice;
        field.list = several;
        if (field.kind == Field::object)
            field.help.replace(0, 2, "name or number"); // of "id of a ..."
        if (field.kind == Field::objects)
            field.help = "names" + field.help.substr(3) + "; commas between them";
        if (field.kind == Field::number && !range.empty()) field.help += "; " + range;
        fields.push_back(std::move(field));
    }
    return true;
}

// A stroke is typed as points of the picture it is seen in, and the view is the last that anybody
// would change.
void ask_for_stroke(CommandForm& form, const Sketch& sketch)
{
    std::stable_partition(form.fields.begin(), form.fields.end(),
                          [](const Field& each) { return !each.name.starts_with("camera."); });
    const auto samples = std::ranges::find(form.fields, "samples", &Field::name);
    const glm::ivec2 size(sketch.camera.size_px);
    samples->label = "Points";
    samples->help = "x and y of each point of the stroke in the picture, which has " +
                    std::to_string(size.x) + " by " + std::to_string(size.y) +
                    " pixels; commas between them";
    const auto at = [&](int x, int y) {
        return std::to_string(size.x * x / 100) + " " + std::to_string(size.y * y / 100);
    };
    samples->ready = {
        {"Across the picture", at(25, 60) + ", " + at(50, 60) + ", " + at(75, 60)},
        {"From near to far", at(50, 85) + ", " + at(50, 65) + ", " + at(50, 45)},
        {"In a wide bend", at(25, 75) + ", " + at(40, 60) + ", " + at(60, 60) + ", " + at(75, 75)},
    };
}

// Returns the typed letters of the object at hand: all of them, or those after the last comma.
std::string_view letters_of(const Field& field)
{
    return field.kind == Field::objects ? cut_at(field.typed, ",").back() : trimmed(field.typed);
}

} // namespace

std::optional<CommandForm> form_of(const Command& ready, std::string title,
                                   const Document& document)
{
    CommandForm form{.title = std::move(title), .otherwise = ready, .fields = {}};
    for (const json& each : json::parse(commands_json()))
        if (each["do"] == verb(ready) && !add_fields(form.fields, each["fields"], ""))
            return std::nullopt;
    if (form.fields.empty()) return std::nullopt;
    if (const auto* place = ready.as<Place>()) ask_for_stroke(form, place->sketch);
    show_present(form, ready, document);
    return form;
}

Command filled(const CommandForm& form, const Document& document)
{
    std::vector<TypedValue> values;
    for (const Field& each : form.fields)
        if (!trimmed(each.typed).empty()) values.push_back({each.name, value_json(each, document)});
    return typed_values(form.otherwise, values, document);
}

void show_present(CommandForm& form, const Command& command, const Document& document)
{
    const json values = json::parse(to_json_line(command));
    for (Field& each : form.fields) {
        if (!each.typed.empty()) continue;
        std::string pointer = "/" + each.name;
        std::ranges::replace(pointer, '.', '/');
        const json::json_pointer at(pointer);
        each.present = present_text(each, values.contains(at) ? values[at] : json(), document);
    }
}

std::vector<FormOption> options_of(const CommandForm& form, const Document& document)
{
    const Field& field = form.fields[form.at];
    std::vector<FormOption> options;
    if (field.kind == Field::choice)
        for (const std::string& each : field.choices) options.push_back({each, each, 0, {}});
    for (const Field::Ready& each : field.ready) options.push_back({each.typed, each.words, 0, {}});
    if (field.kind == Field::object || field.kind == Field::objects) {
        std::map<std::string_view, std::size_t> count; // there may be thousands
        for (const auto& [id, each] : document.objects) ++count[each->name];
        for (const auto& [id, each] : document.objects)
            options.push_back(
                {typed_name(id, each->name, count[each->name], field.kind == Field::objects),
                 printable(each->name),
                 id,
                 {}});
    }
    std::vector<std::string> names;
    names.reserve(options.size());
    for (const FormOption& each : options) names.push_back(each.words);
    std::vector<FormOption> found;
    std::string_view letters = letters_of(field);
    if (letters.starts_with('"')) letters.remove_prefix(1);
    for (RankedName& each : ranked(letters, names, {})) {
        found.push_back(std::move(options[each.index]));
        found.back().letters = std::move(each.letters);
    }
    return found;
}

std::optional<std::size_t> taken_option(const CommandForm& form,
                                        const std::vector<FormOption>& options,
                                        const Document& document)
{
    if (options.empty()) return std::nullopt;
    if (form.chosen) return std::min(*form.chosen, options.size() - 1);
    const Field& field = form.fields[form.at];
    const std::string_view letters = letters_of(field);
    const bool whole = letters.empty() || is_called(document, letters) || is_number(letters) ||
                       is_called(document, trimmed(field.typed)) ||
                       std::ranges::find(field.choices, letters) != field.choices.end() ||
                       (letters.size() > 1 && letters.starts_with('"') && letters.ends_with('"'));
    return whole ? std::nullopt : std::optional<std::size_t>(0);
}

void take(CommandForm& form, const FormOption& option)
{
    Field& field = form.fields[form.at];
    form.chosen.reset();
    if (field.kind != Field::objects) {
        field.typed = option.typed;
        return;
    }
    const std::string_view last = letters_of(field);
    const auto kept = static_cast<std::size_t>(
        last.empty() ? field.typed.size()
                     : static_cast<std::size_t>(last.data() - field.typed.data()));
    std::string before = field.typed.substr(0, kept);
    if (before.ends_with(',')) before += ' ';
    field.typed = before + option.typed;
}

} // namespace trivar

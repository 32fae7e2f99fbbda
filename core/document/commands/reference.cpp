// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/document/commands/json_text.h"

#include <fmt/format.h>
#include <utility>

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
    else if constexpr (std::is_same_v<T, Transform>)
        return "[transform](#transform-1)";
    else if constexpr (std::is_same_v<T, ImportedFile>)
        return "[file](#file)";
    else if constexpr (std::is_same_v<T, Camera>)
        return "[camera](#camera)";
    else if constexpr (std::is_same_v<T, PlacementParameters>)
        return "[parameters](#parameters)";
    else if constexpr (std::is_same_v<T, Sketch>)
        return "[sketch](#sketch)";
    else if constexpr (std::is_same_v<T, CopiedObject>)
        return "[object](#object)";
    else if constexpr (std::is_same_v<T, CopiedPlacement>)
        return "[placement](#placement)";
    else if constexpr (std::is_same_v<T, KnownObject>)
        return "[base](#base)";
    else if constexpr (std::is_same_v<T, Surfacing>)
        return "values of [set_material](#set_material)";
    else if constexpr (std::is_same_v<T, Travel>)
        return "values of [set_travel](#set_travel)";
    else if constexpr (std::is_same_v<T, Playing>)
        return "values of [play_clip](#play_clip)";
    else if constexpr (std::is_same_v<T, Refining>)
        return "values of [refine](#refine)";
    else if constexpr (std::is_same_v<T, VolumeEdit>)
        return "[step](#step)";
    else if constexpr (std::is_same_v<T, Press>)
        return "values of [press](#press)";
    else if constexpr (std::is_same_v<T, PointShift>)
        return "values of [move_points](#move_points)";
    else if constexpr (std::is_same_v<T, KnotInsertion>)
        return "values of [insert_knots](#insert_knots)";
    else if constexpr (std::is_same_v<T, Coarsening>)
        return "values of [coarsen_volume](#coarsen_volume)";
    else if constexpr (std::is_same_v<T, Mending>)
        return "nothing inside: `{}`";
    else if constexpr (std::is_same_v<T, FoldAllowance>)
        return "values of [allow_folds](#allow_folds)";
    else if constexpr (std::is_same_v<T, VolumePart>)
        return "[part](#part)";
    else if constexpr (std::is_same_v<T, ObjectTracks>)
        return "[object's tracks](#objects-tracks)";
    else if constexpr (std::is_same_v<T, Track>)
        return "[track](#track)";
    else if constexpr (std::is_same_v<T, Key>)
        return "[key](#key)";
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
    const Rule free{};
    if (!rule.choices.empty()) {
        std::string text;
        for (const char c : rule.choices) text += c == '|' ? std::string(", ") : std::string(1, c);
        return text;
    }
    if (rule.lo == free.lo && rule.hi == free.hi) return "";
    if (rule.hi != free.hi) return shortest(rule.lo) + " to " + shortest(rule.hi);
    return rule.lo == 0 ? "0 or more" : rule.lo < 1e-6 ? "above 0" : shortest(rule.lo) + " or more";
}

template <class T> std::string default_text(const T& value, const Rule& rule)
{
    if (rule.required) return "required";
    if constexpr (Nested<T>)
        return "its own";
    else if constexpr (is_optional<T>)
        return "nothing";
    else
        return "`" + value_json(value) + "`";
}

template <class T> std::string field_table(const T& value)
{
    std::string text = "| field | type | default | range | meaning |\n|---|---|---|---|---|\n";
    each_field(value, [&]<class V>(std::string_view name, const V& v, std::string_view help,
                                   Rule rule = {}) {
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, type_name<V>(),
                            default_text(v, rule), range(rule), help);
    });
    return text + "\n";
}

template <class T> std::string fields_list(const T& value)
{
    std::string text;
    each_field(value, [&]<class V>(std::string_view name, const V& v, std::string_view help,
                                   Rule rule = {}) {
        if (!text.empty()) text += ",";
        text += "{\"name\":" + json_text(name);
        if constexpr (Nested<V>)
            text += ",\"fields\":" + fields_list(v);
        else {
            text += ",\"type\":" + json_text(type_name<V>());
            if constexpr (!is_optional<V>)
                if (!rule.required) text += ",\"default\":" + value_json(v);
        }
        text += std::string(",\"required\":") + (rule.required ? "true" : "false");
        if (const std::string allowed = range(rule); !allowed.empty())
            text += ",\"range\":" + json_text(allowed);
        text += ",\"help\":" + json_text(help) + "}";
    });
    return "[" + text + "]";
}

// Calls visit(C{}) for every command in the order of the variant.
void each_command(auto&& visit)
{
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        (visit(std::variant_alternative_t<I, Command>{}), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Command>>{});
}

} // namespace

std::string commands_text()
{
    std::string text;
    each_command([&](const auto& c) {
        text += fmt::format("{}\n    {}\n", c.verb, c.summary);
        each_field(c,
                   [&](std::string_view name, const auto&, std::string_view help, Rule rule = {}) {
                       text += fmt::format("    {:<14} {}{}\n", name, help,
                                           rule.required ? " (required)" : "");
                   });
    });
    return text;
}

std::string commands_markdown()
{
    std::string text =
        "# Commands\n\n"
        "Everything that can be done to a scene is one of these commands. A scene file holds one "
        "a line, as a JSON\nobject whose field `do` names the command; [document.md](document.md) "
        "explains the file. A field that is left\nout has its default. This page is written by "
        "`trivar commands --markdown`.\n\n"
        "| command | what it does |\n|---|---|\n";
    each_command([&](const auto& c) {
        text += fmt::format("| [{}](#{}) | {} |\n", c.verb, c.verb, c.summary);
    });
    text += "\n";
    each_command([&](const auto& c) {
        text += fmt::format("## {}\n\n{}\n\n", c.verb, c.summary) + field_table(c);
    });
    text += "# Values inside commands\n\nA sample is a list `[x px, y px, seconds, pressure]`; "
            "pressure and seconds may be left out.\n\n";
    text += "## transform\n\nScale first, then the turns about X, Y and Z, then the "
            "translation.\n\n" +
            field_table(Transform{});
    text += "## file\n\nAn imported model's file, and how it is read.\n\n" +
            field_table(ImportedFile{});
    text += "## camera\n\nA point of view. Pixels count from the top left corner of the "
            "picture.\n\n" +
            field_table(Camera{});
    text += "## parameters\n\nHow an object lies along its stroke.\n\n" +
            field_table(PlacementParameters{});
    text += "## sketch\n\nA stroke and the view it was drawn in.\n\n" + field_table(Sketch{});
    text += "## object\n\nAn object as it is copied.\n\n" + field_table(CopiedObject{});
    text += "## placement\n\nHow a copied object lies.\n\n" + field_table(CopiedPlacement{});
    text += "## step\n\nWhat was done to a volume; one of them.\n\n" + field_table(VolumeEdit{});
    text += "## object's tracks\n\nWhat of one object goes from key to key.\n\n" +
            field_table(ObjectTracks{});
    text += "## track\n\nHow one number goes from key to key.\n\n" + field_table(Track{});
    text += "## key\n\nA value in a frame, and how it goes on.\n\n" + field_table(Key{});
    text += "## part\n\nA box in a volume's own u, v and w.\n\n" + field_table(VolumePart{});
    text += "## base\n\nWhat a copied object lay on.\n\n" + field_table(KnownObject{});
    text.pop_back();
    return text;
}

std::string commands_json()
{
    std::string text;
    each_command([&](const auto& c) {
        if (!text.empty()) text += ",\n";
        text += "{\"do\":" + json_text(c.verb) + ",\"summary\":" + json_text(c.summary) +
                ",\"fields\":" + fields_list(c) + "}";
    });
    return "[" + text + "]\n";
}

} // namespace trivar

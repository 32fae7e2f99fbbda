// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/copied_object.h"
#include "core/commands/every_command.h"
#include "core/commands/json_text.h"
#include "core/commands/words/field_words.h"
#include "core/document/fields/view_fields.h"

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

struct ToldCommand {
    std::string_view verb, summary;
    std::vector<FieldText> fields;
};

// Lists every command, in the order of the variant.
std::vector<ToldCommand> told_commands()
{
    const std::array all = EachOf<CommandKinds>::results([]<class C>() {
        return ToldCommand{C::verb, C::summary, fields_of(C{})};
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
    text += "## transform\n\nScale first, then the turns about X, Y and Z, then the "
            "translation.\n\n" +
            field_table(fields_of(Transform{}));
    text += "## file\n\nAn imported model's file, and how it is read.\n\n" +
            field_table(fields_of(ImportedFile{}));
    text += "## picture\n\nA picture that a mask or heights read.\n\n" +
            field_table(fields_of(RelinkedPicture{}));
    text += "## volume\n\nThe file or the folder of volume data.\n\n" +
            field_table(fields_of(RelinkedVolume{}));
    text += "## reading\n\nWhat files of volume data do not say.\n\n" +
            field_table(fields_of(VolumeReading{}));
    text += "## level\n\nA level of volume data as it is shown.\n\n" +
            field_table(fields_of(VoxelLevel{}));
    text += "## fit\n\nA spline over tetrahedra that shows volume data.\n\n" +
            field_table(fields_of(TetrahedraFit{}));
    text += "## casting\n\nHow volume data are seen as a whole.\n\n" +
            field_table(fields_of(VolumeCasting{}));
    text += "## transfer point\n\nHow a value of volume data looks.\n\n" +
            field_table(fields_of(TransferPoint{}));
    text += "## lines\n\nHow lines are drawn.\n\n" + field_table(fields_of(LineStyle{}));
    text += "## further lines\n\nLines of a surface besides its outlines.\n\n" +
            field_table(fields_of(MoreLines{}));
    text += "## camera\n\nA view of the scene. Pixels count from the top left corner of the "
            "picture.\n\n" +
            field_table(fields_of(Camera{}));
    text += "## parameters\n\nHow an object lies along its stroke.\n\n" +
            field_table(fields_of(PlacementParameters{}));
    text += "## sketch\n\nA stroke and the view it was drawn in.\n\n" +
            field_table(fields_of(Sketch{}));
    text += "## attachment\n\nWhat a stroke belongs to.\n\n" + field_table(fields_of(Attachment{}));
    text += "## host\n\nAn object that carries what lies on it.\n\n" +
            field_table(fields_of(AttachedHost{}));
    text += "## anchor\n\nWhere a sample of a stroke met its host.\n\n" +
            field_table(fields_of(AttachedSample{}));
    text += "## object\n\nAn object as it is copied.\n\n" + field_table(fields_of(CopiedObject{}));
    text +=
        "## placement\n\nHow a copied object lies.\n\n" + field_table(fields_of(CopiedPlacement{}));
    text += "## step\n\nWhat was done to a volume; one of them.\n\n" +
            field_table(fields_of(VolumeEdit{}));
    text += "## object's tracks\n\nWhat of one object goes from key to key.\n\n" +
            field_table(fields_of(ObjectTracks{}));
    text +=
        "## track\n\nHow one number goes from key to key.\n\n" + field_table(fields_of(Track{}));
    text += "## key\n\nA value in a frame, and how it goes on.\n\n" + field_table(fields_of(Key{}));
    text +=
        "## part\n\nA box in a volume's own u, v and w.\n\n" + field_table(fields_of(VolumePart{}));
    text += "## tiling\n\nHow copies of a copied object are painted.\n\n" +
            field_table(fields_of(CopiedTiling{}));
    text += "## mixed tile\n\nAn object among the tiles of a layer.\n\n" +
            field_table(fields_of(MixedTile{}));
    text += "## tile file\n\nA model that comes into the scene as a tile.\n\n" +
            field_table(fields_of(TileFile{}));
    text += "## copied mixed tile\n\nThe same, as it is copied.\n\n" +
            field_table(fields_of(CopiedMixedTile{}));
    text += "## tile stroke\n\nA stroke with which tiles were painted.\n\n" +
            field_table(fields_of(TileStroke{}));
    text +=
        "## tile sample\n\nA point of such a stroke.\n\n" + field_table(fields_of(TileSample{}));
    text += "## tile cover\n\nHow tiles cover a whole surface.\n\n" +
            field_table(fields_of(TileCover{}));
    text += "## obstacle\n\nWhat parts an object.\n\n" + field_table(fields_of(ObstacleUse{}));
    text += "## plain cut\n\nA plane or a stroke that cuts an object in two.\n\n" +
            field_table(fields_of(PlainCut{}));
    text += "## incisions\n\nWhere the skin of a copied object is cut open.\n\n" +
            field_table(fields_of(Incising{}));
    text += "## incision layer\n\nWhat the walls of incisions show down to a depth.\n\n" +
            field_table(fields_of(IncisionLayer{}));
    text += "## surface point\n\nA point of the stroke of an incision.\n\n" +
            field_table(fields_of(SurfacePoint{}));
    text += "## profile\n\nHow a number goes along an incision.\n\n" +
            field_table(fields_of(IncisionProfile{}));
    text += "## tile mask\n\nWhere a layer has more tiles, larger or higher ones.\n\n" +
            field_table(fields_of(TileMask{}));
    text +=
        "## copied mask\n\nThe same, as it is copied.\n\n" + field_table(fields_of(CopiedMask{}));
    text += "## base\n\nWhat a copied object lay on, or was painted on.\n\n" +
            field_table(fields_of(KnownObject{}));
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

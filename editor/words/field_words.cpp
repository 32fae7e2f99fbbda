// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/field_words.h"

#include "core/base/mistake.h"
#include "core/commands/command.h"

#include <map>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

using Helps = std::map<std::string, std::string>; // by "edit_placement parameters.width"

void add_helps(Helps& helps, const nlohmann::json& fields, const std::string& prefix)
{
    for (const nlohmann::json& each : fields) {
        const std::string name = prefix + each["name"].get<std::string>();
        helps[name] = each["help"].get<std::string>();
        if (each.contains("fields")) add_helps(helps, each["fields"], name + ".");
    }
}

Helps all_helps()
{
    Helps helps;
    for (const nlohmann::json& each : nlohmann::json::parse(commands_json()))
        add_helps(helps, each["fields"], each["do"].get<std::string>() + " ");
    return helps;
}

} // namespace

std::string without_unit(std::string_view sentence)
{
    std::string help(sentence);
    for (const std::string_view unit :
         {", metres", ", in degrees", ", in radians", ", degrees", ", pixels", "; pixels"}) {
        const std::size_t at = help.find(unit);
        if (at != help.npos) help.erase(at, unit.size());
    }
    return help;
}

std::string help_of_field(const std::string& verb, const std::string& name)
{
    static const Helps helps = all_helps();
    const auto found = helps.find(verb + " " + name);
    ensure(found != helps.end(), "there is no field of this name");
    return without_unit(found->second);
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/every_command.h"
#include "core/commands/command.h"
#include "core/commands/objects/import.h"

namespace trivar {

Command::Command() : Command(ImportModel{}) {}

bool Command::operator==(const Command& other) const
{
    return kind_ == other.kind_ &&
           (value_ == other.value_ ||
            visit([&]<class C>(const C& c) { return c == *other.as<C>(); }, *this));
}

std::vector<Command> every_command()
{
    const std::array all = EachOf<CommandKinds>::results([]<class C>() { return Command(C{}); });
    return {all.begin(), all.end()};
}

Document after(const Document& document, const Command& command)
{
    check(command);
    return visit([&](const auto& c) { return applied(document, c); }, command);
}

StepTitle step_title(const Command& command, const Document& before, const Document& after)
{
    return visit([&](const auto& c) { return title(c, {before, after}); }, command);
}

CommandNature nature_of(const Command& command)
{
    return visit([]<class C>(const C&) { return nature_of_type<C>(); }, command);
}

std::string_view verb(const Command& command)
{
    return visit([]<class C>(const C&) { return C::verb; }, command);
}

} // namespace trivar

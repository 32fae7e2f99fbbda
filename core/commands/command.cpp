// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"

namespace trivar {

Command::Command() = default;
Command::Command(const Command&) = default;
Command::Command(Command&&) noexcept = default;
Command& Command::operator=(const Command&) = default;
Command& Command::operator=(Command&&) noexcept = default;
Command::~Command() = default;
bool Command::operator==(const Command&) const = default;

std::vector<Command> every_command()
{
    std::vector<Command> all;
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        (all.emplace_back(CommandAt<I>{}), ...);
    }
    (std::make_index_sequence<command_count>{});
    return all;
}

Document after(const Document& document, const Command& command)
{
    check(command);
    return std::visit([&](const auto& c) { return applied(document, c); }, command);
}

StepTitle step_title(const Command& command, const Document& before, const Document& after)
{
    return std::visit([&](const auto& c) { return title(c, {before, after}); }, command);
}

CommandNature nature_of(const Command& command)
{
    return std::visit([]<class C>(const C&) { return nature_of_type<C>(); }, command);
}

std::string_view verb(const Command& command)
{
    return std::visit([]<class C>(const C&) { return C::verb; }, command);
}

} // namespace trivar

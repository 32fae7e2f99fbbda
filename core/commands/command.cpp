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

std::string_view verb(const Command& command)
{
    return std::visit([]<class C>(const C&) { return C::verb; }, command);
}

} // namespace trivar

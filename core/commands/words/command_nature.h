// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// A CommandIcon says what a command is about, for a picture of it beside its title.
enum class CommandIcon {
    values,
    add,
    import_model,
    place,
    move,
    material,
    rename,
    hide,
    show,
    lock,
    unlock,
    remove,
    copy,
    group,
    camera
};

// An Invocation says how a person gives a command.
enum class Invocation {
    with_values, // by filling in its fields
    at_once,     // the selected objects give all its values
    by_actions   // actions and tools of the window give it its values
};

struct CommandNature {
    CommandIcon icon = CommandIcon::values;
    Invocation asked = Invocation::with_values;
};

// The nature of a type of command: its own, or else the default one.
template <class Command> constexpr CommandNature nature_of_type()
{
    if constexpr (requires { Command::nature; })
        return Command::nature;
    else
        return {};
}

} // namespace trivar

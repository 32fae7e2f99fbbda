// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// What a command is about, for a picture of it beside its title.
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

// How a person comes to a command.
enum class Invocation {
    with_values, // by filling in its fields
    at_once,     // the selected objects say all that it needs
    by_actions   // actions and tools of the window give it its values
};

struct CommandNature {
    CommandIcon icon = CommandIcon::values;
    Invocation asked = Invocation::with_values;
};

// The nature of a type of command: its own, or else the usual one.
template <class Command> constexpr CommandNature nature_of_type()
{
    if constexpr (requires { Command::nature; })
        return Command::nature;
    else
        return {};
}

} // namespace trivar

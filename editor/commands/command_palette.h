// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/commands/command_form.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A CommandPalette is the state of the list in which everything can be found: the typed text and
// the chosen row.
struct CommandPalette {
    bool open = false, fresh = false; // fresh: takes the keyboard in its first frame
    std::string typed;
    std::size_t chosen = 0;
    // A command whose values are filled in, shown in place of the list.
    struct Filling {
        CommandForm form;
        std::vector<Id> selected;             // before it began
        std::optional<Command> proposed = {}; // the last that was shown
        bool begun = false;                   // the first was
        bool typing = false;                  // the field at hand has the keyboard
        bool typed_before = false;            // letters came before it had
    };
    std::optional<Filling> filling = {};
    void show() { *this = {.open = true, .fresh = true, .typed = {}}; }
};

} // namespace trivar

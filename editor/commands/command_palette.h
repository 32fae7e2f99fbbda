// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/commands/command_form.h"
#include "ui/keys.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

struct Editor;

// The list that everything can be found in: what the person has typed and which row is chosen.
struct CommandPalette {
    bool open = false, fresh = false; // fresh: takes the keyboard in its first frame
    std::string typed;
    std::size_t chosen = 0;
    // Instead of the list: a command whose values are filled in.
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

struct PaletteEntry {
    std::string name, note; // the note says where it belongs or what it is for
    const char* icon = nullptr;
    std::vector<std::string> key_caps;
    std::string why_not; // empty: it can run
    std::function<void(Editor&)> run;
    std::string action = {};          // whose key can be changed; empty: it is none
    std::optional<Command> fill = {}; // whose values can be filled in first
    bool needs_values = false;        // and have to be
};
// Every action and every command of the document; after ">" the objects, after ":" what can be
// preferred.
std::vector<PaletteEntry> palette_commands(const Editor& editor);
std::vector<PaletteEntry> palette_objects(const Editor& editor);
std::vector<PaletteEntry> palette_preferences(const Editor& editor);

// Values are filled in one field after another and shown in the picture as they are. Nothing is
// done till it runs, as one step.
void begin_filling(Editor& editor, CommandForm form);
void show_filling(Editor& editor); // after a change of the form
// To the field that follows or comes before; it stays where the value at hand is refused. False:
// there is none before.
bool next_field(Editor& editor, int step);
bool run_filled(Editor& editor); // false: refused, and the form says why
void leave_filling(Editor& editor);

// The names that hold the letters in order, the best match first; of equal ones one that is matched
// as a whole, then those used last, then those listed first. Without letters: the recent ones and
// then all others.
struct Ranked {
    std::size_t index = 0;            // in `names`
    std::vector<std::size_t> letters; // that matched
    bool recent = false;
};
std::vector<Ranked> ranked(std::string_view letters, const std::vector<std::string>& names,
                           const std::vector<std::string>& recent);

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

struct Editor;

// A PaletteEntry is an entry of the palette: an action, a command, an object or a preference.
struct PaletteEntry {
    std::string name, note; // the note says where it belongs or what it is for
    const char* icon = nullptr;
    std::vector<std::string> key_caps;
    std::string why_not; // empty: it can run
    std::function<void(Editor&)> run;
    std::string action = {};          // the action whose key can be changed; empty: none
    std::optional<Command> fill = {}; // the command whose values can be filled in first
    bool needs_values = false;        // the values must be filled in
};
// Every action and every command of the document; after ">" the objects, after ":" the preferences.
std::vector<PaletteEntry> palette_commands(const Editor& editor);
std::vector<PaletteEntry> palette_objects(const Editor& editor);
std::vector<PaletteEntry> palette_preferences(const Editor& editor);

} // namespace trivar

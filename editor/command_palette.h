// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    void show() { *this = {.open = true, .fresh = true, .typed = {}}; }
};

struct PaletteEntry {
    std::string name, note; // the note says where it belongs or what it is for
    const char* icon = nullptr;
    std::vector<std::string> key_caps;
    std::string why_not; // empty: it can run
    std::function<void(Editor&)> run;
    std::string action = {}; // whose key can be changed; empty: it is none
};
// Every action and every command of the document; after ">" the objects, after ":" what can be
// preferred.
std::vector<PaletteEntry> palette_commands(const Editor& editor);
std::vector<PaletteEntry> palette_objects(const Editor& editor);
std::vector<PaletteEntry> palette_preferences(const Editor& editor);

// The names that hold the letters in order, the best match first; of equal ones those used last,
// then those listed first. Without letters: the recent ones and then all others.
struct Ranked {
    std::size_t index = 0;            // in `names`
    std::vector<std::size_t> letters; // that matched
    bool recent = false;
};
std::vector<Ranked> ranked(std::string_view letters, const std::vector<std::string>& names,
                           const std::vector<std::string>& recent);

} // namespace trivar

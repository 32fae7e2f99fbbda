// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// PreferencesDialog is the state of the dialog of the preferences between two frames.
struct PreferencesDialog {
    enum Page { // in the order of their names
        of_general,
        of_interface,
        of_viewport,
        of_mouse,
        of_keys,
        of_files,
        of_performance,
        of_accessibility,
        of_about,
        page_count
    };
    bool open = false;
    int page = of_general;
    std::string filter;                   // of the key map
    std::string asking;                   // the action whose new key is waited for
    std::string given;                    // the action that got one last ...
    std::vector<std::string> losers;      // ... and those that lost it
    bool show_asking = false;             // scroll to it
    bool resetting = false;               // the rows of the page, as they are drawn next
    bool seeking = false;                 // a key is waited for, to show whose it is
    std::optional<ui::Chord> sought;      // that key
    std::optional<std::size_t> discarded; // scenes; counted when they are first shown
};

const char* preferences_page_name(int page);

} // namespace trivar

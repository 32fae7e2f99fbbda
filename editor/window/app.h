// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

struct EditorOptions {
    std::vector<std::string> files;   // a scene opens, models are imported
    std::vector<std::string> samples; // scenes offered where nothing is open yet
    std::vector<std::string> tutorials;
    std::string manual, sample_pictures, models; // folders
    std::string shaders; // a checkout whose shaders are drawn with; empty: none
    double scale = 0;    // of the interface; 0: TRIVAR_SCALE or the monitor's
    bool light = false;
    bool tell_steps = false; // says on standard output, before each frame, how many it shows
};

// The editor in a window, till it is closed. Exit status 0, or 1 with a sentence on stderr where
// no window can be opened.
int run_editor(const EditorOptions& options);

} // namespace trivar

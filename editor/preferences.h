// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/key_map.h"
#include "ui/palette.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// What a person has arranged, for all scenes. Sizes are pixels at scale 1.
struct Preferences {
    double scale = 1; // of the interface, times the monitor's, 0.75..2
    double dock = 320, outliner = 256, timeline = 184;
    bool show_dock = true, timeline_open = false, hints = true;
    bool loop = true;                     // playing goes on at the first frame
    ui::Look look;                        // of the interface
    bool reduced_motion = false;          // what would move is there at once
    bool backdrop_as_in_pictures = false; // of the viewport; else the window's own
    std::string quality = "automatic";    // of the viewport; or a level of the renderer
    std::string deform = "processor";     // where the viewport's meshes are: gpu::deform_names
    KeyMap keys;
    std::vector<std::string> recent_commands, recent_scenes; // the newest first
    bool operator==(const Preferences&) const = default;
};

// Text of JSON. Anything odd in it (another type, a size out of range, a list too long, no JSON at
// all) is as if it were not there, for a program must start whatever its settings say.
Preferences preferences_from(std::string_view text);
std::string text_of(const Preferences& preferences);

// Puts it in front of the list, once.
void remember(std::vector<std::string>& recent, const std::string& what);

// The scales of the interface that can be chosen, rising; and the next one up or down.
inline constexpr std::array interface_scales{0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 2.0};
double next_scale(double scale, int direction);

// Preferences in a file, written when they differ from what it holds. Without a path in memory.
class PreferencesFile {
public:
    explicit PreferencesFile(std::string path);
    const Preferences& read() const { return kept_; } // as they were when it was opened
    // Why they could not be written, once; else nothing.
    std::string keep(const Preferences& preferences);

private:
    std::string path_;
    Preferences kept_;
    bool failed_ = false;
};

} // namespace trivar

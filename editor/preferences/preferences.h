// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/preferences/key_map.h"
#include "editor/preferences/mouse_manners.h"
#include "ui/palette.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Preferences are a person's settings for all scenes. Sizes are pixels at scale 1.
struct Preferences {
    double scale = 1; // of the interface, times the monitor's, 0.75..2
    double dock = 320, outliner = 256, timeline = 184;
    bool show_dock = true, timeline_open = false, hints = true;
    std::string at_start = "card"; // over an empty scene; or "last", the last scene, or "empty"
    bool ask_to_keep = true;       // what becomes of a scene without a name
    bool loop = true;              // playing goes on at the first frame
    ui::Look look;                 // of the interface
    bool reduced_motion = false;   // what would move is there at once
    bool backdrop_as_in_pictures = false; // of the viewport; else the window's own
    bool grid = true, show_axes = true;   // of the viewport; what turns the view by a click
    bool show_timing = true;              // how long pictures take, in a corner of it
    std::string quality = "automatic";    // of the viewport; or a level of the renderer
    std::string pace = "automatic";       // pictures a second while something moves; or a number
    std::string deform = "automatic";     // where the viewport's meshes are, or gpu::deform_names
    std::string view_tolerance = "off";   // pixels that triangles may be off in the window, or off
    double threads = 0;                   // that evaluate at the same time; 0: all there are
    MouseManners mouse;
    KeyMap keys;
    double discarded_days = 30;               // till what was discarded is forgotten
    double most_recent = 16;                  // scenes that are remembered
    std::string scenes_folder, models_folder; // where dialogs begin; empty: where they were
    std::vector<std::string> recent_commands, recent_scenes; // the newest first
    std::vector<std::string> library_tiles; // models that were dropped to paint with, newest first
    std::vector<std::string> recent_views;  // lines of editor/session/recent_views.h
    std::vector<std::string> closed_hints;  // by name: they do not come again
    bool operator==(const Preferences&) const = default;
};

// Reads preferences from JSON text. Values of a wrong type, and text that is no JSON, count as
// missing, and a number out of its range becomes the nearest one in it, because a program must
// start with any settings. `odd` names these values, or "the whole file" where it is no JSON. Lists
// are cut at their greatest length, and odd entries are left out: `odd` then names the list, for
// keys "keys, Undo".
struct ReadPreferences {
    Preferences preferences;
    std::vector<std::string> odd;
};
ReadPreferences read_preferences(std::string_view text);
inline Preferences preferences_from(std::string_view text)
{
    return read_preferences(text).preferences;
}
std::string text_of(const Preferences& preferences);

// Puts an entry at the front of a list, in which it stands once.
inline constexpr std::size_t most_remembered = 16;
void remember(std::vector<std::string>& recent, const std::string& what,
              std::size_t most = most_remembered);

// The scales of the interface that can be chosen, ascending; and the next one up or down.
inline constexpr std::array interface_scales{0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 2.0};
double next_scale(double scale, int direction);

// A PreferencesFile keeps preferences in a file and writes them when they differ from its content.
// Without a path it keeps them in memory.
class PreferencesFile {
public:
    explicit PreferencesFile(std::string path);
    const Preferences& read() const { return kept_; } // as they were when it was opened
    const std::string& path() const { return path_; }
    // A sentence that says what is odd in the file; empty: nothing. A file that is no JSON is kept
    // beside the new one; one that cannot be read is not touched, and the preferences are then kept
    // in memory.
    const std::string& trouble() const { return trouble_; }
    // Writes the preferences; returns why they could not be written, once, else empty.
    std::string keep(const Preferences& preferences);

private:
    std::string path_;
    Preferences kept_;
    std::string trouble_;
    bool failed_ = false;
};

} // namespace trivar

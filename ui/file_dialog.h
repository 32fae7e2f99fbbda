// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/file_entries.h"
#include "ui/theme.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trivar::ui {

// A FileRequest is the input of a file dialog.
struct FileRequest {
    std::string title;                   // "Open a scene"
    std::string action;                  // on the button: "Open"
    std::vector<std::string> extensions; // with the dot, lower case; empty: all files
    bool saving = false; // a new name may be typed; it gets the first extension where it has none
    bool folder = false; // with saving: a folder is chosen, which need not exist
    std::string name;    // suggested
    std::string option = {}; // of a check box at the foot; empty: none
    bool option_on = false;  // at first
    // The words of a button that takes the selected folder, else the shown one; empty: no button.
    std::string take_folder = {};
};

// A FileDialog browses folders inside the window: click and double click, arrows, Enter, Backspace
// for the folder above, or a path typed or pasted into its field. Tab goes to its buttons. Esc
// closes it. An existing file is replaced by the button or by Ctrl Enter, not by Enter alone.
class FileDialog {
public:
    void open(FileRequest request, const std::filesystem::path& start = {});
    bool is_open() const { return open_; }
    bool option_on() const { return request_.option_on; } // of the last request
    // Opens the dialog again as it was, with the typed text, and says why that could not be done.
    void ask_again(std::string problem);
    // Draws the dialog if it is open; returns the chosen path in the frame in which it was chosen.
    std::optional<std::string> draw(const Theme& theme);

private:
    void enter(const std::filesystem::path& folder);
    void move_focus();
    std::optional<std::string> take(const std::string& typed, bool replace = false);
    std::optional<std::string> take_folder();
    bool replaces() const; // a file with the typed name exists
    std::optional<std::string> draw_list(const Theme& theme, float height);
    std::filesystem::path absolute(const std::string& typed) const;
    std::filesystem::path with_extension(std::filesystem::path path) const; // where it has none

    // The part that has the keyboard, in the order of Tab.
    enum class Focus { field, option, cancel, agree };
    Focus focus_ = Focus::field;
    bool open_ = false, just_opened_ = false;
    bool select_stem_ = false; // of the suggested name, once its field has the keyboard
    bool entered_ = false;     // a folder, by a press that is still held
    FileRequest request_;
    std::filesystem::path folder_;      // listed
    std::filesystem::path next_folder_; // where the next dialog begins
    std::vector<FileEntry> entries_;
    int selected_ = -1;
    std::string typed_;   // the path or name field
    std::string problem_; // why the last choice was not taken
};

} // namespace trivar::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A history that is kept in a file as it grows: each commit, undo and redo appends its line, so a
// killed process loses no committed command and undo survives closing the program. While it lives
// the file is locked; who opens it a second time gets a copy without a path, or only looks at it.
//
// A scene without a name can be kept the same way, in a file of a folder for such scenes, which
// goes when the scene gets a name. What a killed program left there can be taken up again; what
// was let go on purpose is set aside there till it is old enough to be forgotten.
//
// When appending fails (disk full, file taken away) the step stands, `trouble` says so, the file
// keeps its last whole line, and the next step or save tries again with all that is missing.
class SceneFile {
public:
    SceneFile();                                 // without a name: in memory only, till kept_in
    explicit SceneFile(const std::string& path); // replays it. Throws Rejected
    // A copy without a path of a file that stays as it is. Throws Rejected.
    static SceneFile copy_of(const std::string& path);
    // The same to look at: it refuses every change with a sentence till it is saved under another
    // name, and follows the file. Throws Rejected.
    static SceneFile looked_at(const std::string& path);
    // The file of the latest scene without a name that a program which is gone left in the folder.
    static std::optional<std::string> left_in(const std::string& folder);
    static SceneFile taken_up(const std::string& left); // goes on with it. Throws Rejected
    // Sets aside what is left, as if it had been let go. Throws Rejected.
    static void set_aside(const std::string& left) { taken_up(left); }
    // The files of the scenes that were set aside in the folder, the latest first.
    static std::vector<std::string> set_aside_in(const std::string& folder);
    ~SceneFile();
    SceneFile(SceneFile&&) noexcept;
    SceneFile& operator=(SceneFile&&) noexcept;

    const History& history() const;
    // The lines of the file as they stand there, or would, header first, without line breaks.
    const std::vector<std::string>& lines() const;
    const Document& document() const { return history().document(); }

    // As in History.
    void propose(Command command);
    bool commit();
    void cancel();
    void run(Command command, const std::string& note = {});
    bool undo();
    bool redo();

    // Shows a copy, to which nothing was done, as it was after so many steps. That does nothing to
    // it either. No effect on other scenes.
    void look_at(std::size_t position);

    // Takes up what was added to the file that is looked at; whether there was anything. A file
    // that was replaced is read anew. Throws Rejected.
    bool follow();

    // Writes the whole history, or only the steps in force (which forgets the undone ones), beside
    // the target, renames it over it and goes on there. In another folder the paths of imports
    // are rewritten. Throws Rejected, and neither the file at `path` nor this has changed.
    void save_as(const std::string& path);
    void save_compact(const std::string& path);
    // The whole history in a new file; this goes on where it is. Throws Rejected, and where a file
    // is there already.
    void save_copy(const std::string& path) const;
    void write_missing(); // tries again what an append could not write

    // From its next step on a scene without a name is kept in the folder, which is made where it
    // is missing. No effect on other scenes, nor with an empty name; `trouble` says what fails.
    void keep_in(const std::string& folder);

    const std::string& path() const;     // empty: without a name, or a copy
    const std::string& original() const; // the file it is a copy of; empty: none
    bool as_opened() const;              // nothing was done since, so closing it loses nothing
    bool in_use() const;                 // a copy because another program has the file open
    bool look_only() const;
    std::string folder() const;         // absolute; what paths of imports are relative to
    const std::string& trouble() const; // why the last append failed; empty: all is on disk
    const std::vector<std::string>& notices() const; // from opening, one sentence each

private:
    void check_may_change() const;
    void keep_torn(); // beside the file, with .torn after its name, before its end is cut off
    void append(const std::string& line);
    void start_kept();
    void save(const std::string& path, bool compact);
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar

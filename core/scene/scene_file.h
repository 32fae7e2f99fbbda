// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A SceneFile is a history that is kept in a file as it grows: each commit, undo and redo appends
// its line, so a killed process loses no committed command, and undo survives closing the program.
// While it lives the file is locked; a person who opens it a second time gets a copy without a
// path, or only looks at it.
//
// A scene without a name can be kept the same way, in a file of a folder for such scenes, which is
// removed when the scene gets a name. A scene that a killed program left there can be taken up
// again; one that was closed on purpose is set aside there until it is old enough to be deleted.
//
// When appending fails (disk full, file removed) the step stands, `trouble` says so, the file keeps
// its last whole line, and the next step or save tries again with all missing lines.
class SceneFile {
public:
    SceneFile();                                 // without a name: in memory only, until keep_in()
    explicit SceneFile(const std::string& path); // replays it. Throws Rejected
    // A copy without a path of a file that stays as it is, or of all but its last lines. Throws
    // Rejected.
    static SceneFile copy_of(const std::string& path, std::size_t without_last = 0);
    // Opens a scene to look at it: it refuses every change with a sentence until it is saved under
    // another name, and follows changes of the file. Throws Rejected.
    static SceneFile looked_at(const std::string& path);
    // The file of the latest scene without a name that a program left in the folder when it ended.
    // One that cannot be read stays there; one that ended two programs that read it is set aside.
    static std::optional<std::string> left_in(const std::string& folder);
    static SceneFile taken_up(const std::string& left); // continues a left scene. Throws Rejected
    // Sets aside a left scene, as if it had been closed. Throws Rejected.
    static void set_aside(const std::string& left) { taken_up(left); }
    // The files of the scenes that were set aside in the folder, the latest first.
    static std::vector<std::string> set_aside_in(const std::string& folder);
    ~SceneFile();
    SceneFile(SceneFile&&) noexcept;
    SceneFile& operator=(SceneFile&&) noexcept;

    const History& history() const;
    // The lines of the file, or those that it would have, with the header first, without line
    // breaks.
    const std::vector<std::string>& lines() const;
    const Document& document() const { return history().document(); }

    // Work as in History, for commands that are given now: see check_new().
    void propose(Command command);
    bool commit();
    void cancel();
    void run(Command command, const std::string& note = {});
    bool undo();
    bool redo();

    // Shows an unchanged copy as it was after `position` steps. The copy itself does not change. No
    // effect on other scenes.
    void look_at(std::size_t position);

    // Takes up lines that were added to a file that is only looked at; returns whether there were
    // any. A file that was replaced is read anew. Throws Rejected.
    bool follow();

    // Writes the whole history, or only the steps in force (which forgets the undone ones), beside
    // the target, renames that file over the target and continues there. In another folder the
    // paths of imports are rewritten, and shapes that were kept while the scene had no name are
    // copied there. If it throws Rejected, neither the file at `path` nor this scene has changed.
    void save_as(const std::string& path);
    void save_compact(const std::string& path);
    // Writes the whole history into a new file; this scene continues where it is. Throws Rejected,
    // also where a file exists there already.
    void save_copy(const std::string& path) const;
    void write_missing(); // tries again to write what an append could not write

    // Keeps a scene without a name in the folder from its next step on; the folder is made where it
    // is missing. No effect on other scenes, nor with an empty name; `trouble` says what fails.
    void keep_in(const std::string& folder);

    // The folder for files of shapes that this scene keeps: its own, or while it has no name one in
    // the folder for such scenes, which is made. Throws Rejected where it is in memory only.
    std::string make_shapes_folder();

    const std::string& path() const;     // empty: a scene without a name, or a copy
    const std::string& original() const; // the file it is a copy of; empty: none
    const std::string& file() const; // that is written, of a scene without a name too; empty: none
    bool as_opened() const; // nothing was done since it was opened, so closing it loses nothing
    bool in_use() const;    // a copy because another program has the file open
    bool look_only() const;
    std::string folder() const;         // absolute; paths of imports are relative to it
    const std::string& trouble() const; // why the last append failed; empty: all is on disk
    const std::vector<std::string>& notices() const; // from opening, one sentence each

private:
    void check_may_change() const;
    void check_given(const Command& command) const;
    void keep_torn(); // beside the file, with .torn after its name, before its end is cut off
    void append(const std::string& line);
    void start_kept();
    void save(const std::string& path, bool compact);
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace trivar

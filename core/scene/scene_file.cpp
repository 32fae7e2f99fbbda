// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene_file.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/scene/kept_scenes.h"
#include "core/scene/life_sign.h"
#include "core/scene/locked_file.h"
#include "core/scene/log.h"
#include "core/scene/moved_history.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <optional>
#include <sys/stat.h>
#include <utility>

namespace trivar {

struct SceneFile::State {
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State()
    {
        if (file && path.empty()) put_aside(file_path);
    }
    // Closes the file, as the scene gets another name; a file without a name is removed.
    void let_go()
    {
        std::error_code ignored;
        const bool unnamed = file && path.empty();
        if (unnamed) std::filesystem::remove(file_path, ignored);
        file.reset();
        if (unnamed) remove_unused_shapes(std::filesystem::path(file_path).parent_path().string());
    }

    History history;
    std::vector<std::string> lines = lines_of(log_header());
    bool as_opened = true, in_use = false, look_only = false;
    ino_t looked_at = 0;  // inode of the file that is followed
    std::string original; // path of the original of a copy
    std::string path, folder = absolute_folder("");
    std::string kept_in; // folder for scenes without a name; empty: not kept
    std::optional<LockedFile> file;
    std::string file_path;     // `path`, or the path of the unnamed copy
    std::uintmax_t length = 0; // of the whole lines of the file
    std::string missing;       // lines that are not in the file yet
    std::string torn;          // the file as it was found, kept before its end is cut off
    std::string trouble;
    std::vector<std::string> notices;
};

SceneFile::SceneFile() : state_(std::make_unique<State>()) {}
SceneFile::~SceneFile() = default;
SceneFile::SceneFile(SceneFile&&) noexcept = default;
SceneFile& SceneFile::operator=(SceneFile&&) noexcept = default;

SceneFile::SceneFile(const std::string& path) : state_(std::make_unique<State>())
{
    LockedFile file(path);
    std::string text = file.read();
    const Log log = read_log(text, path);
    state_->history = replay(log);
    state_->lines = lines_of(std::string_view(text).substr(0, log.good_bytes));
    state_->folder = absolute_folder(path);
    state_->original = path; // until it proves to be that very file
    if (!log.notice.empty()) state_->notices.push_back(log.notice);
    if (file.access() == LockedFile::Access::in_use) {
        state_->in_use = true;
        state_->notices.push_back(fmt::format(
            "{}: is open in another Trivar; this is a copy, so save it under another name", path));
        return;
    }
    if (file.access() == LockedFile::Access::read_only) {
        state_->notices.push_back(
            fmt::format("{}: is read-only; save changes under another name", path));
        return;
    }
    state_->path = state_->file_path = path;
    state_->original.clear();
    state_->length = log.good_bytes;
    if (!log.notice.empty()) state_->torn = std::move(text);
    if (!log.ends_with_break) state_->missing = "\n";
    state_->file.emplace(std::move(file));
}

SceneFile SceneFile::copy_of(const std::string& path, std::size_t without_last)
{
    const std::string text = without_last_lines(read_text_file(path), without_last);
    const Log log = read_log(text, path);
    SceneFile scene;
    State& s = *scene.state_;
    s.history = replay(log);
    s.lines = lines_of(std::string_view(text).substr(0, log.good_bytes));
    s.folder = absolute_folder(path);
    s.original = path;
    if (!log.notice.empty()) s.notices.push_back(log.notice);
    if (without_last > 0)
        s.notices.push_back(fmt::format(
            "{}: Trivar ended twice while it read this scene; this is a copy without its last "
            "{}, so save it under another name",
            path, without_last == 1 ? "line" : fmt::format("{} lines", without_last)));
    return scene;
}

SceneFile SceneFile::looked_at(const std::string& path)
{
    struct stat status {};
    const bool there = ::stat(path.c_str(), &status) == 0; // before reading: lines may be added
    SceneFile scene = copy_of(path);
    State& s = *scene.state_;
    s.look_only = true;
    s.looked_at = there ? status.st_ino : 0;
    s.notices.clear(); // a torn line is still being written
    for (const std::string& line : s.lines) s.length += line.size() + 1;
    return scene;
}

bool SceneFile::follow()
{
    State& s = *state_;
    struct stat status {};
    if (!s.look_only || ::stat(s.original.c_str(), &status) != 0) return false;
    const auto size = static_cast<std::uintmax_t>(status.st_size);
    if (status.st_ino != s.looked_at || size < s.length) {
        *this = looked_at(std::string(s.original));
        return true;
    }
    if (size == s.length) return false;
    std::ifstream file(s.original, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(s.length));
    bool more = false;
    for (std::string line; std::getline(file, line) && !file.eof(); more = true) {
        apply(s.history, read_log_line(line), s.original);
        s.length += line.size() + 1;
        s.lines.push_back(std::move(line));
    }
    return more;
}

void SceneFile::check_may_change() const
{
    if (!state_->look_only) return;
    throw Rejected(fmt::format("{} is open read-only here; save it under another name to change it",
                               std::filesystem::path(state_->original).filename().string()));
}

std::optional<std::string> SceneFile::left_in(const std::string& folder)
{
    for (const auto& [time, path] : scenes_in(folder, kept_name)) {
        try {
            const LifeSign reading(folder, path + reading_sign, 0, true);
            if (reading.steps_too_many() > 0) {
                put_aside(path);
                continue;
            }
            const SceneFile scene(path);
            const bool in_use = scene.path().empty();
            if (!in_use && !scene.history().steps().empty()) return path;
        } catch (const std::exception&) { // stays there, to be repaired by hand
        }
    }
    return std::nullopt;
}

std::vector<std::string> SceneFile::set_aside_in(const std::string& folder)
{
    return paths_of(scenes_in(folder, aside_name));
}

SceneFile SceneFile::taken_up(const std::string& left)
{
    static_cast<void>(SceneFile(left)); // throws if it cannot be read
    SceneFile scene(brought_back(left));
    State& s = *scene.state_;
    s.path.clear();
    s.as_opened = false;
    s.torn.clear(); // half a line of a scene without a name
    return scene;
}

void SceneFile::keep_in(const std::string& folder)
{
    State& s = *state_;
    if (folder.empty() || !s.path.empty() || s.file || s.look_only) return;
    s.kept_in = folder;
    const std::string from = std::exchange(s.folder, std::filesystem::absolute(folder).string());
    if (imports_by_relative_path(s.history)) s.history = moved(s.history, from, s.folder);
    if (!s.as_opened) start_kept();
}

void SceneFile::start_kept()
{
    State& s = *state_;
    if (s.kept_in.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(s.kept_in, ignored); // if this fails, writing reports why
    const std::string path = free_kept_path(s.kept_in);
    try {
        const std::string text = log_text(s.history);
        s.file.emplace(path, text);
        s.file_path = path;
        s.length = text.size();
        s.lines = lines_of(text);
        s.trouble.clear();
    } catch (const Rejected& error) {
        s.trouble = error.what();
    }
}

std::string SceneFile::make_shapes_folder()
{
    check_may_change();
    State& s = *state_;
    if (!s.path.empty()) return s.folder;
    if (!s.file) start_kept();
    if (!s.file)
        throw Rejected(s.trouble.empty() ? "the scene has no folder yet; save it first"
                                         : s.trouble);
    const std::string folder = kept_shapes_of(s.file_path);
    Copies made;
    made.make_folder(folder);
    made.keep();
    return folder;
}

const History& SceneFile::history() const
{
    return state_->history;
}

const std::vector<std::string>& SceneFile::lines() const
{
    return state_->lines;
}

void SceneFile::keep_torn()
{
    if (state_->torn.empty()) return;
    const LockedFile kept(state_->file_path + ".torn", state_->torn);
    state_->torn.clear();
}

void SceneFile::append(const std::string& line)
{
    State& s = *state_;
    s.as_opened = false;
    s.lines.push_back(line.substr(0, line.size() - 1));
    if (!s.file) return start_kept();
    s.missing += line;
    write_missing();
}

void SceneFile::write_missing()
{
    State& s = *state_;
    if (!s.file) {
        if (!s.trouble.empty()) start_kept();
        return;
    }
    try {
        keep_torn();
    } catch (const Rejected& error) {
        s.trouble = error.what();
        return;
    }
    s.trouble = s.file->write_at(s.length, s.missing);
    if (!s.trouble.empty()) return;
    s.length += s.missing.size();
    s.missing.clear();
}

void SceneFile::save_copy(const std::string& path) const
{
    const State& s = *state_;
    if (std::filesystem::exists(path))
        throw Rejected(path + ": exists already and is not replaced");
    Copies copies;
    const std::optional<History> other =
        moved_with_shapes(s.history, s.folder, absolute_folder(path), copies);
    const LockedFile file(path, log_text(other ? *other : s.history));
    copies.keep();
}

// Checks a new command. A command that begins a known branch was checked when the branch was made.
void SceneFile::check_given(const Command& command) const
{
    check_may_change();
    const History& history = state_->history;
    const bool known = std::ranges::any_of(history.branches(), [&](const History::Branch& branch) {
        return branch.from == history.position() && branch.steps.front().command == command;
    });
    if (!known) check_new(history.committed(), command);
}

void SceneFile::propose(Command command)
{
    check_given(command);
    state_->history.propose(std::move(command));
}

bool SceneFile::commit()
{
    if (!state_->history.commit()) return false;
    const History& history = state_->history;
    const History::Step& step = history.steps()[history.position() - 1];
    append(command_line(step.command, step.note));
    return true;
}

void SceneFile::cancel()
{
    state_->history.cancel();
}

void SceneFile::run(Command command, const std::string& note)
{
    check_given(command);
    state_->history.propose(std::move(command), note);
    commit();
}

void SceneFile::look_at(std::size_t position)
{
    State& s = *state_;
    if (!s.as_opened || s.file) return;
    while (s.history.position() > position && s.history.undo()) {
    }
    while (s.history.position() < position && s.history.redo()) {
    }
    s.lines = lines_of(log_text(s.history));
}

bool SceneFile::undo()
{
    check_may_change();
    if (!state_->history.undo()) return false;
    append(undo_line());
    return true;
}

bool SceneFile::redo()
{
    check_may_change();
    if (!state_->history.redo()) return false;
    append(redo_line());
    return true;
}

void SceneFile::save(const std::string& path, bool compact)
{
    State& s = *state_;
    const std::string folder = absolute_folder(path);
    std::error_code ignored;
    const bool in_place = !s.path.empty() && std::filesystem::equivalent(path, s.path, ignored);
    if (!in_place && std::filesystem::is_regular_file(path, ignored) &&
        LockedFile(path).access() == LockedFile::Access::in_use)
        throw Rejected(path + ": is open in another Trivar; choose another name");
    History kept = s.history;
    if (compact) kept.forget_undone();
    Copies copies;
    if (auto other = moved_with_shapes(kept, s.folder, folder, copies)) kept = std::move(*other);
    const std::string text = compact ? compact_log_text(kept) : log_text(kept);
    if (in_place) keep_torn();
    LockedFile file(path, text);
    copies.keep();
    s.let_go();
    s.history = std::move(kept);
    s.history.cancel();
    s.file.emplace(std::move(file));
    s.path = s.file_path = path;
    s.original.clear();
    s.in_use = s.look_only = false;
    s.folder = folder;
    s.length = text.size();
    s.lines = lines_of(text);
    s.missing.clear();
    s.torn.clear();
    s.trouble.clear();
}

void SceneFile::save_as(const std::string& path)
{
    save(path, false);
}

void SceneFile::save_compact(const std::string& path)
{
    save(path, true);
}

const std::string& SceneFile::path() const
{
    return state_->path;
}

const std::string& SceneFile::file() const
{
    return state_->file ? state_->file_path : state_->path;
}

const std::string& SceneFile::original() const
{
    return state_->original;
}

bool SceneFile::in_use() const
{
    return state_->in_use;
}

bool SceneFile::look_only() const
{
    return state_->look_only;
}

bool SceneFile::as_opened() const
{
    return state_->as_opened;
}

std::string SceneFile::folder() const
{
    return state_->folder;
}

const std::string& SceneFile::trouble() const
{
    return state_->trouble;
}

const std::vector<std::string>& SceneFile::notices() const
{
    return state_->notices;
}

} // namespace trivar

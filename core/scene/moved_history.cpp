// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/moved_history.h"

#include "core/commands/every_command.h"
#include "core/document/each_name.h"
#include "core/document/fields/object_fields.h"
#include "core/document/named_files.h"
#include "core/scene/kept_scenes.h"

#include <algorithm>
#include <map>
#include <utility>

namespace trivar {
namespace {

// Returns the names of the files that a command names, to be read or changed.
std::vector<std::string*> files_of(Command& command)
{
    std::vector<std::string*> files;
    change(command, [&](auto& c) {
        each_file(c, [&](const auto& file, const auto&) {
            if (is_file_path(file.kind, file.path)) files.push_back(&file.path);
        });
    });
    return files;
}

bool is_relative(const std::string* file)
{
    return std::filesystem::path(*file).is_relative();
}

std::filesystem::path absolute(const std::string& file, const std::filesystem::path& folder)
{
    return (folder / file).lexically_normal();
}

// Finds a name for a copy of the file that is free or has the same content.
std::filesystem::path place_for(const std::filesystem::path& file,
                                const std::filesystem::path& folder)
{
    const auto usable = [&](const std::string& path) {
        std::error_code ignored;
        return !std::filesystem::exists(path, ignored) || same_content(path, file);
    };
    const std::string path = (folder / file.filename()).string();
    return usable(path) ? path : numbered_name(path, usable);
}

// NewPaths maps the old path of a file to its new one, both absolute.
using NewPaths = std::map<std::filesystem::path, std::filesystem::path>;

NewPaths shapes_brought(const History& history, const std::filesystem::path& from,
                        const std::filesystem::path& to, Copies& copies)
{
    NewPaths brought;
    const auto bring = [&](const std::string& file) {
        const std::filesystem::path path = absolute(file, from);
        std::error_code ignored;
        if (brought.contains(path) || !is_kept_shape(path, from) ||
            !std::filesystem::is_regular_file(path, ignored))
            return;
        const std::filesystem::path place = place_for(path, to).lexically_normal();
        if (!std::filesystem::exists(place, ignored)) copies.copy(path, place);
        brought[path] = place;
    };
    history.retell(
        [&](const History::Step& step) {
            Command command = step.command;
            for (const std::string* file : files_of(command)) bring(*file);
        },
        [] {});
    return brought;
}

History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to, const NewPaths& brought)
{
    History result;
    history.retell(
        [&](const History::Step& step) {
            Command command = step.command;
            for (std::string* file : files_of(command)) {
                if (!is_relative(file)) continue;
                const std::filesystem::path path = absolute(*file, from);
                const auto found = brought.find(path);
                const std::filesystem::path& now = found == brought.end() ? path : found->second;
                *file = now.lexically_relative(to).string();
            }
            result.run(std::move(command), step.note);
        },
        [&] { result.undo(); });
    return result;
}

} // namespace

bool imports_by_relative_path(const History& history)
{
    bool found = false;
    history.retell(
        [&](const History::Step& step) {
            Command command = step.command;
            found = found || std::ranges::any_of(files_of(command), is_relative);
        },
        [] {});
    return found;
}

History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to)
{
    return moved(history, from, to, {});
}

std::optional<History> moved_with_shapes(const History& history, const std::filesystem::path& from,
                                         const std::filesystem::path& to, Copies& copies)
{
    if (from == to || !imports_by_relative_path(history)) return {};
    return moved(history, from, to, shapes_brought(history, from, to, copies));
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/moved_history.h"

#include <algorithm>
#include <utility>

namespace trivar {
namespace {

// The files that a command names, which may be changed where the command may.
template <class C> auto files_of(C& command)
{
    using File = std::conditional_t<std::is_const_v<C>, const ImportedFile, ImportedFile>;
    std::vector<File*> files;
    if (auto* import = std::get_if<ImportModel>(&command)) files.push_back(&import->file);
    if (auto* edit = std::get_if<EditImport>(&command)) files.push_back(&edit->file);
    if (auto* relink = std::get_if<Relink>(&command))
        for (auto& file : relink->files) files.push_back(&file);
    if (auto* kept = std::get_if<KeepShape>(&command))
        for (auto& file : kept->files) files.push_back(&file);
    if (auto* paste = std::get_if<Paste>(&command))
        for (auto& copy : paste->copies)
            if (copy.file) files.push_back(&*copy.file);
    return files;
}

bool is_relative(const ImportedFile* file)
{
    return std::filesystem::path(file->path).is_relative();
}

} // namespace

bool imports_by_relative_path(const History::Step& step)
{
    return std::ranges::any_of(files_of(step.command), is_relative);
}

History moved(const History& history, const std::filesystem::path& from,
              const std::filesystem::path& to)
{
    History result;
    history.retell(
        [&](const History::Step& step) {
            Command command = step.command;
            for (ImportedFile* file : files_of(command))
                if (is_relative(file))
                    file->path =
                        (from / file->path).lexically_normal().lexically_relative(to).string();
            result.run(std::move(command), step.note);
        },
        [&] { result.undo(); });
    return result;
}

} // namespace trivar

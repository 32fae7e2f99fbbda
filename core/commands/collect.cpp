// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/collect.h"

#include "core/base/rejected.h"
#include "core/document/named_files.h"
#include "core/files/companions.h"
#include "core/files/copies.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <vector>

namespace trivar {
namespace {

namespace fs = std::filesystem;

// A Bundle is the file of a model and the files that it names, a picture alone, or the files of
// volume data, relative to one folder.
struct Bundle {
    fs::path from;
    std::vector<fs::path> files; // the one that is named first, unless the folder is named
    bool folder = false;         // it is the folder that is named
    // Returns the name for a folder of its own.
    std::string stem() const
    {
        return folder ? from.filename().string() : files.front().stem().string();
    }
};

Bundle bundle_of(const fs::path& path, const FileUse& use, const AssetStore& assets)
{
    if (use.kind == FileKind::volume) {
        const bool folder = fs::is_directory(path);
        Bundle bundle{folder ? path : path.parent_path(), {}, folder};
        for (const std::string& each : files_of_volume(use, assets))
            bundle.files.push_back(fs::path(each).lexically_relative(bundle.from));
        if (bundle.files.empty())
            throw Rejected(
                fmt::format("{}: cannot be read; find it first, then collect again", use.path));
        return bundle;
    }
    Bundle bundle{path.parent_path(), {path.filename()}};
    if (use.kind == FileKind::model)
        for (const std::string& each : companions_of(path.string()))
            bundle.files.emplace_back(each);
    return bundle;
}

// Whether nothing else lies there: all files of a folder of volume data may be slices of it.
bool only_holds(const Bundle& bundle, const fs::path& folder)
{
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (std::ranges::find(bundle.files, at->path().filename()) == bundle.files.end())
            return false;
    return true;
}

// Says whether a bundle can be copied there: no file of the same name has other content.
bool fits(const Bundle& bundle, const fs::path& folder)
{
    std::error_code ignored;
    if (bundle.folder && !only_holds(bundle, folder)) return false;
    for (const fs::path& each : bundle.files)
        if (fs::exists(folder / each, ignored) && !same_content(bundle.from / each, folder / each))
            return false;
    return true;
}

// Chooses the place of a bundle: a single file goes into the folder itself, several into a folder
// of their own.
fs::path place_for(const Bundle& bundle, const fs::path& folder)
{
    const bool alone = bundle.files.size() == 1 && !bundle.folder;
    const std::string stem = bundle.stem();
    if (alone && fits(bundle, folder)) return folder;
    for (int n = 1;; ++n) {
        const fs::path own = folder / (n == 1 ? stem : fmt::format("{}_{}", stem, n));
        std::error_code ignored;
        if ((!fs::exists(own, ignored) || fs::is_directory(own, ignored)) && fits(bundle, own))
            return own;
    }
}

bool lies_in(const fs::path& file, const fs::path& folder)
{
    const fs::path relative = file.lexically_normal().lexically_relative(folder.lexically_normal());
    return !relative.empty() && *relative.begin() != "..";
}

using Users = std::vector<std::pair<Id, FileUse>>; // of one file

// How a file is copied that is used in several ways: volume data and models with all their files.
const FileUse& most_of(const Users& users)
{
    const auto weight = [](const auto& user) {
        const FileKind kind = user.second.kind;
        return kind == FileKind::volume ? 2 : kind == FileKind::model ? 1 : 0;
    };
    return std::ranges::max_element(users, {}, weight)->second;
}

void take_from(Relink& command, const std::string& path, Id id, const FileUse& use,
               const Document& document)
{
    switch (use.kind) {
    case FileKind::model:
        command.objects.push_back(id);
        command.files.push_back(std::get<ImportedFile>(object(document, id).source));
        command.files.back().path = path;
        return;
    case FileKind::image: command.pictures.push_back({id, use.mask, path, use.hash}); return;
    case FileKind::volume: command.volumes.push_back({id, path, use.hash}); return;
    case FileKind::font: return;
    }
}

} // namespace

Collection collect_files(const Document& document, const AssetStore& assets,
                         const std::string& folder, const Progress& progress)
{
    std::map<std::string, Users> users; // of each file
    for (const auto& [id, each] : document.objects)
        for (const FileUse& use : files_named(*each)) {
            if (use.kind == FileKind::font) continue; // named from the root
            const std::string path =
                fs::absolute(assets.resolve(use.path)).lexically_normal().string();
            if (lies_in(path, folder)) continue;
            std::error_code ignored;
            if (!fs::is_regular_file(path, ignored) &&
                !(use.kind == FileKind::volume && fs::is_directory(path, ignored)))
                throw Rejected(
                    fmt::format("{}: is missing; find it first, then collect again", use.path));
            users[path].emplace_back(id, use);
        }
    Collection result;
    if (users.empty()) return result;
    Copies copies;
    Relink command;
    std::size_t done = 0;
    for (const auto& [path, uses] : users) {
        const Bundle bundle = bundle_of(path, most_of(uses), assets);
        const fs::path to = place_for(bundle, folder);
        for (const fs::path& each : bundle.files) {
            report(progress, static_cast<double>(done) / static_cast<double>(users.size()),
                   "copying " + each.filename().string());
            std::error_code ignored;
            if (fs::exists(to / each, ignored)) {
                ++result.reused;
                continue;
            }
            copies.copy(bundle.from / each, to / each);
            ++result.copied;
        }
        ++done;
        const fs::path copy = bundle.folder ? to : to / bundle.files.front();
        std::string name = copy.lexically_relative(assets.folder()).string();
        if (name.empty()) name = copy.string();
        for (const auto& [id, use] : uses) take_from(command, name, id, use, document);
    }
    copies.keep();
    result.command = std::move(command);
    return result;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/collect.h"

#include "core/base/rejected.h"
#include "core/files/companions.h"
#include "core/files/copies.h"

#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <vector>

namespace trivar {
namespace {

namespace fs = std::filesystem;

// A Bundle is the file of a model and the files that it names, relative to one folder.
struct Bundle {
    fs::path from;
    std::vector<fs::path> files; // the model first
};

Bundle bundle_of(const fs::path& path)
{
    Bundle bundle{path.parent_path(), {path.filename()}};
    for (const std::string& each : companions_of(path.string())) bundle.files.emplace_back(each);
    return bundle;
}

// Says whether a bundle can be copied there: no file of the same name has other content.
bool fits(const Bundle& bundle, const fs::path& folder)
{
    std::error_code ignored;
    for (const fs::path& each : bundle.files)
        if (fs::exists(folder / each, ignored) && !same_content(bundle.from / each, folder / each))
            return false;
    return true;
}

// Chooses the place of a bundle: a single file goes into the folder itself, several into a folder
// of their own.
fs::path place_for(const Bundle& bundle, const fs::path& folder)
{
    const bool alone = bundle.files.size() == 1;
    const fs::path stem = bundle.files.front().stem();
    if (alone && fits(bundle, folder)) return folder;
    for (int n = 1;; ++n) {
        const fs::path own =
            folder / (n == 1 ? stem : fs::path(fmt::format("{}_{}", stem.string(), n)));
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

} // namespace

Collection collect_files(const Document& document, const AssetStore& assets,
                         const std::string& folder, const Progress& progress)
{
    std::map<std::string, std::vector<Id>> users; // of each file
    std::size_t files = 0;
    for (const auto& [id, each] : document.objects)
        if (const auto* file = std::get_if<ImportedFile>(&each->source)) {
            const std::string path = fs::absolute(assets.resolve(file->path)).string();
            if (lies_in(path, folder)) continue;
            std::error_code ignored;
            if (!fs::is_regular_file(path, ignored))
                throw Rejected(
                    fmt::format("{}: is missing; find it first, then collect again", file->path));
            users[path].push_back(id);
            ++files;
        }
    Collection result;
    if (users.empty()) return result;
    Copies copies;
    Relink command;
    for (const auto& [path, ids] : users) {
        const Bundle bundle = bundle_of(path);
        const fs::path to = place_for(bundle, folder);
        for (const fs::path& each : bundle.files) {
            report(progress,
                   static_cast<double>(command.objects.size()) / static_cast<double>(files),
                   "copying " + each.filename().string());
            std::error_code ignored;
            if (fs::exists(to / each, ignored)) {
                ++result.reused;
                continue;
            }
            copies.copy(bundle.from / each, to / each);
            ++result.copied;
        }
        const fs::path copy = to / bundle.files.front();
        for (const Id id : ids) {
            ImportedFile file = std::get<ImportedFile>(object(document, id).source);
            file.path = copy.lexically_relative(assets.folder()).string();
            if (file.path.empty()) file.path = copy.string();
            command.objects.push_back(id);
            command.files.push_back(std::move(file));
        }
    }
    copies.keep();
    result.command = std::move(command);
    return result;
}

} // namespace trivar

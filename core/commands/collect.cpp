// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/collect.h"

#include "core/base/rejected.h"
#include "core/files/companions.h"
#include "core/files/file_bytes.h"

#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <unistd.h>
#include <vector>

namespace trivar {
namespace {

namespace fs = std::filesystem;

bool same_content(const fs::path& a, const fs::path& b)
{
    std::error_code ignored;
    return fs::equivalent(a, b, ignored) ||
           (fs::file_size(a, ignored) == fs::file_size(b, ignored) &&
            file_hash(a.string()) == file_hash(b.string()));
}

// Copies that go again unless they are kept.
class Copies {
public:
    Copies() = default;
    Copies(const Copies&) = delete;
    Copies& operator=(const Copies&) = delete;
    ~Copies()
    {
        std::error_code ignored;
        for (auto each = made_.rbegin(); each != made_.rend(); ++each) fs::remove(*each, ignored);
    }
    void keep() { made_.clear(); }

    // Of the folders that lead to a file, those that are missing.
    void make_folder(const fs::path& folder)
    {
        std::error_code error;
        if (folder.empty() || fs::is_directory(folder, error)) return;
        make_folder(folder.parent_path());
        if (!fs::create_directory(folder, error))
            throw Rejected(fmt::format("{}: the folder cannot be made ({})", folder.string(),
                                       error ? error.message() : "something is in its place"));
        made_.push_back(folder);
    }
    void copy(const fs::path& from, const fs::path& to)
    {
        make_folder(to.parent_path());
        const fs::path beside = to.string() + fmt::format(".{}.part", ::getpid());
        made_.push_back(beside);
        std::error_code error;
        const bool copied = fs::copy_file(from, beside, fs::copy_options::none, error);
        if (copied) fs::rename(beside, to, error);
        if (!copied || error)
            throw Rejected(fmt::format("{}: cannot be copied to {} ({}); nothing has changed",
                                       from.filename().string(), to.parent_path().string(),
                                       error.message()));
        made_.back() = to;
    }

private:
    std::vector<fs::path> made_;
};

// A model's file and what goes with it, all as from one folder.
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

// Whether it can lie there: no file is in the way of another content.
bool fits(const Bundle& bundle, const fs::path& folder)
{
    std::error_code ignored;
    for (const fs::path& each : bundle.files)
        if (fs::exists(folder / each, ignored) && !same_content(bundle.from / each, folder / each))
            return false;
    return true;
}

// A file that stands alone lies in the folder itself, else in one of its own.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/folder_files.h"

#include "core/files/gltf/gltf_uri.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace trivar {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 4096;  // of a path, like the bound of the system
constexpr std::size_t most_in_vain = 10000; // names that are not found
constexpr int most_names = 10000;           // in a folder; a folder with more is not one of a model

std::string in_small_letters(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

// Returns the name as a path from the folder, without `.` and `..`; none if it leads out of the
// folder.
std::optional<std::string> relative_path(std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.find('\0') != name.npos || name.find("://") != name.npos) return {};
    const fs::path relative = fs::path(name).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") return {};
    return relative.generic_string();
}

} // namespace

FolderFiles::FolderFiles(const std::string& folder)
{
    std::error_code error;
    if (!folder.empty()) root_ = fs::canonical(folder, error).string();
}

std::optional<NamedFile> FolderFiles::find(std::string_view name)
{
    if (root_.empty() || name.size() > longest_name) return {};
    if (in_vain_.size() == most_in_vain || in_vain_.contains(name)) return {};
    const std::string written(name), decoded = without_escapes(written);
    const auto either = [&](auto look) -> std::optional<NamedFile> {
        for (const std::string& each : {written, decoded})
            if (const auto relative = relative_path(each))
                if (auto found = look(*relative)) return found;
        return {};
    };
    if (auto found = either([&](const auto& path) { return at(path); })) return found;
    if (auto found = either([&](const auto& path) { return in_other_case(path); })) return found;
    in_vain_.insert(written);
    return {};
}

std::optional<NamedFile> FolderFiles::at(const std::string& relative) const
{
    std::error_code error;
    const fs::path root(root_), file = fs::canonical(root / relative, error);
    if (error || !fs::is_regular_file(file, error)) return {};
    const auto [end, ignored] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (end != root.end()) return {};
    return NamedFile{file.string(), relative};
}

std::optional<NamedFile> FolderFiles::in_other_case(const std::string& relative)
{
    fs::path path;
    for (const fs::path& part : fs::path(relative)) {
        const Names& names = names_in(path.generic_string());
        const auto found = names.find(in_small_letters(part.string()));
        if (found == names.end() || found->second.empty()) return {};
        path /= found->second;
    }
    auto file = at(path.generic_string());
    if (file) file->in_other_case = true;
    return file;
}

const FolderFiles::Names& FolderFiles::names_in(const std::string& folder)
{
    const auto [entry, fresh] = listed_.try_emplace(folder);
    if (!fresh) return entry->second;
    int count = 0;
    std::error_code error;
    for (fs::directory_iterator at(fs::path(root_) / folder, error), end;
         !error && at != end && count < most_names; at.increment(error), ++count) {
        const std::string name = at->path().filename().string();
        const auto [same, first] = entry->second.try_emplace(in_small_letters(name), name);
        if (!first) same->second.clear();
    }
    return entry->second;
}

} // namespace trivar

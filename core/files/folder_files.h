// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace trivar {

// A NamedFile is a file that another file names.
struct NamedFile {
    std::string path;           // to open it by
    std::string name;           // its path in the folder, with '/'
    bool in_other_case = false; // it was written with different capitals
    auto operator<=>(const NamedFile&) const = default;
};

// FolderFiles finds the files that a model names, all of them in the model's folder or further in.
// A name may come from a system that writes '\' for '/', from the web, where a blank is '%20', or
// from a system that does not distinguish capitals: it is looked for as it is written, then
// decoded, then in other capitals, if exactly one file matches. Absolute names, schemes, `..` and
// links that lead out of the folder find nothing, and an empty folder's name finds nothing at all.
// After ten thousand failures it stops looking, because a file made of names would take for ever.
class FolderFiles {
public:
    explicit FolderFiles(const std::string& folder);

    std::optional<NamedFile> find(std::string_view name);

private:
    // The names by their form in small letters; empty where several names have that form.
    using Names = std::map<std::string, std::string>;
    std::optional<NamedFile> at(const std::string& relative) const;
    std::optional<NamedFile> in_other_case(const std::string& relative);
    const Names& names_in(const std::string& folder);

    std::set<std::string, std::less<>> in_vain_; // names that were not found
    std::string root_;                           // with links followed
    std::map<std::string, Names> listed_;        // by folder, as from the root
};

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/folder_files.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A VolumeSource is what each reader of volumes gets: the whole file that is opened, and the way to
// the files beside it that it names.
class VolumeSource {
public:
    // `name` is that of the file, for sentences; other files are read from `folder`, none if it is
    // empty. All files together may have at most `most_bytes`.
    VolumeSource(std::string_view bytes, std::string name, const std::string& folder,
                 std::uintmax_t most_bytes);

    std::string_view bytes() const { return bytes_; }
    const std::string& name() const { return name_; }

    // The path of a file beside it, found as FolderFiles does; it counts as read from now on.
    // Throws Rejected where there is none.
    std::string beside(std::string_view name);
    // The bytes of such a file. Throws Rejected, also where all of them are too many.
    std::string read_beside(std::string_view name);
    // The names of these files in the folder, each once, sorted.
    std::vector<std::string> companions() const { return {companions_.begin(), companions_.end()}; }

    // Throws Rejected: "name: reason".
    [[noreturn]] void refuse(std::string_view reason) const;
    // Adds a sentence for the user, in which the file's name comes first.
    void say(std::string_view sentence);
    const std::vector<std::string>& notices() const { return notices_; }

private:
    std::string_view bytes_;
    std::string name_;
    FolderFiles files_;
    std::uintmax_t bytes_left_;
    std::set<std::string> companions_;
    std::vector<std::string> notices_;
};

} // namespace trivar

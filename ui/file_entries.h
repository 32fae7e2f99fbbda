// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace trivar::ui {

struct FileEntry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
    bool operator==(const FileEntry&) const = default;
};

// Folders first, then the files with one of the extensions, both in the order people expect
// (model2 before model10, no difference of case). Hidden ones are left out. An unreadable folder
// is empty.
std::vector<FileEntry> entries_of(const std::filesystem::path& folder,
                                  const std::vector<std::string>& extensions);
bool natural_less(const std::string& a, const std::string& b);
// Whatever its case; none at all: any name.
bool has_extension(const std::string& name, const std::vector<std::string>& extensions);

} // namespace trivar::ui

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

// The folders, followed by the files with one of the extensions, both in the order people expect
// (model2 before model10, in any case of letters). Hidden files are left out. An unreadable folder
// counts as empty.
std::vector<FileEntry> entries_of(const std::filesystem::path& folder,
                                  const std::vector<std::string>& extensions);
bool natural_less(const std::string& a, const std::string& b);
// Whether a name has one of the extensions, in any case of letters; without extensions always true.
bool has_extension(const std::string& name, const std::vector<std::string>& extensions);

} // namespace trivar::ui

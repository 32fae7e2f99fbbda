// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trivar {

bool same_content(const std::filesystem::path& a, const std::filesystem::path& b);

// The first usable name beside a file: a_001.trivar, then a_002.trivar. Usable without a test:
// there is no such file.
std::string numbered_name(const std::string& path,
                          const std::function<bool(const std::string&)>& usable = nullptr);

// Copies are files and folders that were made, which are removed again unless they are kept.
class Copies {
public:
    Copies() = default;
    Copies(const Copies&) = delete;
    Copies& operator=(const Copies&) = delete;
    ~Copies();
    void keep() { made_.clear(); }

    // Makes those of the folders that lead there that are missing. Throws Rejected.
    void make_folder(const std::filesystem::path& folder);
    // Copies a file, completely or not at all. Throws Rejected.
    void copy(const std::filesystem::path& from, const std::filesystem::path& to);

private:
    std::vector<std::filesystem::path> made_;
};

} // namespace trivar

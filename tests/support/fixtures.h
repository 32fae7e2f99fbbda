// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace trivar::testing {

// A fresh empty folder for one test, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

// Writes a file, bytes as they are, and the folders that it is to stand in.
void write_file(const std::filesystem::path& path, const std::string& bytes);

// The folder of real models and volumes, from the environment's TRIVAR_DATA or ../shared/data
// beside the checkout; empty where there is none. Tests that want it carry the label `realdata`
// (their suite's name starts with RealData) and skip with a message.
std::string real_data_folder();

} // namespace trivar::testing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The files of scenes without a name, in a folder for them.

namespace trivar {

// A scene without a name is kept as untitled-PROCESS-NUMBER.trivar.
inline constexpr const char* kept_name = "untitled-";
inline constexpr const char* kept_extension = ".trivar";
// What was set aside is found by the time of that.
inline constexpr const char* aside_name = "discarded ";

std::string absolute_folder(const std::string& path);

using TimedPaths = std::vector<std::pair<std::filesystem::file_time_type, std::string>>;
std::vector<std::string> paths_of(const TimedPaths& scenes);
// The files of such names in a folder with the time they were written last, the latest first.
TimedPaths scenes_in(const std::string& folder, std::string_view name);
// Those that were set aside so long ago.
void forget_old_scenes(const std::string& folder, std::chrono::hours aside_for);

std::string free_kept_path(const std::string& folder);
// What was set aside is worked on again: under which path.
std::string brought_back(const std::string& path);
// A name that no file has, which says when: "discarded 2025-03-01 16.40.trivar".
void put_aside(const std::string& path);

} // namespace trivar

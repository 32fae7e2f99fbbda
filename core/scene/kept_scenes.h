// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// These functions handle the files of scenes without a name, in a folder for them. What such a
// scene writes beside its log, the shapes that it keeps, is in a folder of its own there.

namespace trivar {

// A scene without a name is kept as untitled-PROCESS-NUMBER.trivar.
inline constexpr const char* kept_name = "untitled-";
inline constexpr const char* kept_extension = ".trivar";
// The prefix of a scene that was set aside; the time when that happened follows it.
inline constexpr const char* aside_name = "discarded ";

std::string absolute_folder(const std::string& path);

using TimedPaths = std::vector<std::pair<std::filesystem::file_time_type, std::string>>;
std::vector<std::string> paths_of(const TimedPaths& scenes);
// The files in a folder whose name begins so, with the time of their last change, the latest first.
TimedPaths scenes_in(const std::string& folder, std::string_view name);
// Deletes scenes that were set aside at least that long ago, with the folders of their kept shapes,
// and life signs as old.
void forget_old_scenes(const std::string& folder, std::chrono::hours aside_for);

std::string free_kept_path(const std::string& folder);
// Brings back a scene that was set aside; returns its new path.
std::string brought_back(const std::string& path);
// Renames a scene to an unused name that says when: "discarded 2025-03-01 16.40.trivar".
void put_aside(const std::string& path);

// The folder for kept shapes of the scene at that path: "untitled-12-1 kept shapes". It keeps its
// name when the scene is set aside or brought back.
std::string kept_shapes_of(const std::string& scene_path);
// Whether a file lies in such a folder in `folder`.
bool is_kept_shape(const std::filesystem::path& file, const std::filesystem::path& folder);
// Deletes such folders that no scene in `folder` names; the one of a scene that is there stays.
void remove_unused_shapes(const std::string& folder);

} // namespace trivar

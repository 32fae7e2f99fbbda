// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace trivar {

// The last part of a path: what a person calls the file.
inline std::string file_name(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}
// The same at the beginning of a sentence: in quotes where it would pass for a word.
inline std::string file_first(const std::string& path)
{
    const std::string name = file_name(path);
    return name.find('.') == name.npos ? "\"" + name + "\"" : name;
}

// The reason as the body of a notice whose title names the file already.
std::string reason(const std::string& why, const std::string& path);

// A folder as people write it, ~/scenes, and the other way round.
std::string with_short_home(const std::string& folder);
std::string with_long_home(const std::string& folder);

// The words of the check box of exports that have instances.
inline constexpr const char* tiles_as_instances = "Tiles as instances";

// "for 30 days", "for a year".
std::string for_days(int days);

} // namespace trivar

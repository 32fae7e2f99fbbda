// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/recent_scenes.h"

#include "editor/words/file_words.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <sys/stat.h>

namespace trivar {
std::string scene_title(const std::string& path)
{
    std::string name = std::filesystem::path(path).stem().string();
    std::ranges::replace(name, '_', ' ');
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool symbol = i + 1 < name.size() && name[i + 1] >= '0' && name[i + 1] <= '9';
        if ((i == 0 || symbol) && name[i] >= 'a' && name[i] <= 'z')
            name[i] = static_cast<char>(name[i] - 'a' + 'A');
    }
    return name;
}

std::string day_words(std::time_t then, std::time_t now)
{
    constexpr std::array<const char*, 12> months{"January",   "February", "March",    "April",
                                                 "May",       "June",     "July",     "August",
                                                 "September", "October",  "November", "December"};
    std::tm at{}, today{};
    if (!::localtime_r(&then, &at) || !::localtime_r(&now, &today)) return {};
    // The day before today, whatever the clocks did in between.
    std::tm before = today;
    before.tm_hour = 12;
    --before.tm_mday;
    before.tm_isdst = -1;
    std::mktime(&before);
    const auto same = [&](const std::tm& day) {
        return at.tm_year == day.tm_year && at.tm_yday == day.tm_yday;
    };
    if (same(today)) return fmt::format("Today, {:02}:{:02}", at.tm_hour, at.tm_min);
    if (same(before)) return "Yesterday";
    const std::string day =
        fmt::format("{} {}", at.tm_mday, months.at(static_cast<std::size_t>(at.tm_mon)));
    return at.tm_year == today.tm_year ? day : fmt::format("{} {}", day, at.tm_year + 1900);
}

void forget_moved(std::vector<std::string>& paths, const std::string& found)
{
    const auto name = std::filesystem::path(found).filename();
    std::erase_if(paths, [&](const std::string& each) {
        std::error_code ignored;
        return each != found && std::filesystem::path(each).filename() == name &&
               !std::filesystem::exists(each, ignored);
    });
}

const std::vector<RecentScene>& RecentScenes::of(const std::vector<std::string>& paths)
{
    if (paths == paths_) return scenes_;
    paths_ = paths;
    scenes_.clear();
    for (const std::string& each : paths) {
        const std::filesystem::path path(each);
        struct stat status {};
        const bool there = ::stat(each.c_str(), &status) == 0 && S_ISREG(status.st_mode);
        scenes_.push_back({each, path.stem().string(), with_short_home(path.parent_path().string()),
                           there, there ? status.st_mtime : 0});
    }
    return scenes_;
}

} // namespace trivar

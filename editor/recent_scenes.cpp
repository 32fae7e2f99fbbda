// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/recent_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace trivar {
namespace {

std::string with_short_home(const std::string& folder)
{
    const char* home = std::getenv("HOME");
    if (!home || !*home || !folder.starts_with(home)) return folder;
    const std::string rest = folder.substr(std::string_view(home).size());
    return rest.empty() || rest.front() == '/' ? "~" + rest : folder;
}

} // namespace

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

const std::vector<RecentScene>& RecentScenes::of(const std::vector<std::string>& paths)
{
    if (paths == paths_) return scenes_;
    paths_ = paths;
    scenes_.clear();
    for (const std::string& each : paths) {
        const std::filesystem::path path(each);
        std::error_code ignored;
        scenes_.push_back({each, path.stem().string(), with_short_home(path.parent_path().string()),
                           std::filesystem::is_regular_file(path, ignored)});
    }
    return scenes_;
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/file_words.h"

#include <cstdlib>
#include <string_view>

namespace trivar {

std::string reason(const std::string& why, const std::string& path)
{
    for (const std::string& name : {file_name(path), path}) {
        if (name.empty() || !why.starts_with(name + ":")) continue;
        const std::string rest = why.substr(name.size() + 1);
        if (rest.starts_with(" ")) return rest.substr(1);
        return "line " + rest; // "scene.trivar:4: ..."
    }
    return why;
}

std::string with_short_home(const std::string& folder)
{
    const char* home = std::getenv("HOME");
    if (!home || !*home || !folder.starts_with(home)) return folder;
    const std::string rest = folder.substr(std::string_view(home).size());
    return rest.empty() || rest.front() == '/' ? "~" + rest : folder;
}

std::string with_long_home(const std::string& folder)
{
    const char* home = std::getenv("HOME");
    return home && (folder == "~" || folder.starts_with("~/")) ? home + folder.substr(1) : folder;
}

std::string for_days(int days)
{
    if (days == 365) return "for a year";
    return "for " + (days == 1 ? std::string("a day") : std::to_string(days) + " days");
}

} // namespace trivar

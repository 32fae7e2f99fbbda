// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

// A scene that was worked on, for lists of them.
struct RecentScene {
    std::string path, name, folder; // the folder as people write it: ~/scenes
    bool there = false;
};

// The name of a file as the title of what is in it: first_placement.trivar is First placement.
std::string scene_title(const std::string& path);

// Looks on the disk only when the list of paths is another one than at the last call.
class RecentScenes {
public:
    const std::vector<RecentScene>& of(const std::vector<std::string>& paths);

private:
    std::vector<std::string> paths_;
    std::vector<RecentScene> scenes_;
};

} // namespace trivar

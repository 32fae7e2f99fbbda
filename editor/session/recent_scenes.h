// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>
#include <string>
#include <vector>

namespace trivar {

// A RecentScene is a scene that was worked on, for lists of them.
struct RecentScene {
    std::string path, name, folder; // the folder as people write it: ~/scenes
    bool there = false;
    std::time_t changed = 0; // when it was written last, where it is there
};

// The name of a file as the title of its scene: first_placement.trivar is First placement.
std::string scene_title(const std::string& path);

// The date as one would say it now, local time: "Today, 14:20", "Yesterday", "12 March", "12 March
// 2023".
std::string day_words(std::time_t then, std::time_t now);

// Removes missing scenes that have the name of this one, because it was found again.
void forget_moved(std::vector<std::string>& paths, const std::string& found);

// RecentScenes looks on the disk only when the list of paths has changed since the last call.
class RecentScenes {
public:
    const std::vector<RecentScene>& of(const std::vector<std::string>& paths);

private:
    std::vector<std::string> paths_;
    std::vector<RecentScene> scenes_;
};

} // namespace trivar

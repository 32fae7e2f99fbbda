// SPDX-License-Identifier: GPL-3.0-or-later
// How a session keeps its scene on disk.
#include "core/base/rejected.h"
#include "editor/session/session.h"
#include "editor/session/topics.h"

namespace trivar {

void Session::save_as(const std::string& path)
{
    scene_.cancel();
    scene_.save_as(path);
    meet_document(); // imports are read from the new folder now
}

void Session::save_compact(const std::string& path)
{
    scene_.cancel();
    scene_.save_compact(path);
    meet_document();
}

void Session::try_to_write(double time_s)
{
    constexpr double patience_s = 5; // between two tries
    if (scene_.trouble().empty() || time_s < next_try_s_) return;
    next_try_s_ = time_s + patience_s;
    scene_.write_missing();
    if (!scene_.trouble().empty()) return;
    told_trouble_.clear();
    notices.forget(of_saving);
    notices.say(ui::NoticeKind::good, "Everything is on disk again");
}

void Session::follow_file(double time_s)
{
    constexpr double pace_s = 1;
    if (!scene_.look_only() || time_s < next_look_s_) return;
    next_look_s_ = time_s + pace_s;
    try {
        if (scene_.follow()) refresh();
    } catch (const Rejected& why) {
        notices.say(ui::NoticeKind::warning, why.what(), {}, of_saving);
    }
}

} // namespace trivar

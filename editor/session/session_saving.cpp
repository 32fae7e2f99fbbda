// SPDX-License-Identifier: GPL-3.0-or-later
// How a session keeps its scene on disk.
#include "core/base/rejected.h"
#include "editor/session/session.h"
#include "editor/session/topics.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

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

void Session::be_at_work(bool in_frame)
{
    const std::string& named = scene_.file().empty() ? scene_.original() : scene_.file();
    const std::string path =
        named.empty() ? "" : std::filesystem::absolute(named).lexically_normal().string();
    const std::size_t lines = scene_.lines().size();
    if (!life_sign_ || life_sign_->scene() != path) {
        life_sign_.reset();
        if (!path.empty()) life_sign_.emplace(unnamed_folder_, path, lines);
    }
    // A crash during a gesture is not blamed on a step.
    if (life_sign_)
        life_sign_->follow(lines, !proposing() && (in_frame || evaluator_->status().busy));
}

// A scene whose last step ended every program that opened it, opens without that.
void Session::take_back_deadly_steps()
{
    be_at_work(false);
    const History& history = scene_.history();
    const std::size_t position = history.position();
    const std::size_t count = std::min(life_sign_ ? life_sign_->steps_too_many() : 0, position);
    if (count == 0) return;
    const Document& before = position > 1 ? history.steps()[position - 2].result : history.start();
    const History::Step& last = history.steps()[position - 1];
    const std::string title = step_title(last.command, before, last.result).text();
    if (scene_.file().empty()) scene_.look_at(position - count);
    for (std::size_t i = 0; i < count && !scene_.file().empty(); ++i) scene_.undo();
    life_sign_->take_back(scene_.lines().size());
    constexpr const char* of_deadly_steps = "deadly steps";
    const bool one = count == 1;
    const std::string undone =
        one ? fmt::format("Its last step, \"{}\", was undone and can be redone.", title)
            : fmt::format("Its last {} steps were undone and can be redone.", count);
    notices.say(ui::NoticeKind::warning,
                one ? "The last step was undone"
                    : fmt::format("The last {} steps were undone", count),
                "Trivar ended twice while it worked on this scene. " + undone, of_deadly_steps,
                {{"Redo", [this, position, scene = scenes_] {
                      if (scene == scenes_) look_at_step(position);
                  }}});
    notices.keep(of_deadly_steps);
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

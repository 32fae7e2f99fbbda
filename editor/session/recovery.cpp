// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/recovery.h"

#include "core/base/rejected.h"
#include "core/scene/kept_scenes.h"
#include "editor/session/topics.h"
#include "editor/words/file_words.h"

#include <sys/stat.h>
#include <utility>

namespace trivar {

Recovery::Recovery(Session& session) : session_(&session)
{
    session.when_discarded = [this] { tell_of_discarded(); };
}

Recovery::~Recovery()
{
    session_->when_discarded = nullptr;
}

void Recovery::forget_discarded() const
{
    if (!session_->unnamed_folder().empty())
        forget_old_scenes(session_->unnamed_folder(), std::chrono::days(discarded_days));
}

void Recovery::tell_of_discarded()
{
    forget_discarded();
    const auto discarded = SceneFile::set_aside_in(session_->unnamed_folder());
    if (discarded.empty()) return;
    session_->notices.say(ui::NoticeKind::good, "The scene was discarded",
                          "It stays in the recovery folder " + for_days(discarded_days) + ".", {},
                          {{"Recover", [this, path = discarded.front()] { take_up(path); }}});
}

bool Recovery::take_up(const std::string& path)
{
    try {
        session_->replace_scene(SceneFile::taken_up(path));
        return true;
    } catch (const Rejected& why) {
        session_->notices.say(ui::NoticeKind::error, file_name(path) + " was not opened",
                              reason(why.what(), path));
        return false;
    }
}

void Recovery::take_up_left_scene()
{
    const std::optional<std::string> left = SceneFile::left_in(session_->unnamed_folder());
    if (!left || !take_up(*left)) return;
    session_->notices.forget(of_left_scene);
    session_->notices.say(ui::NoticeKind::warning, "Your scene is back",
                          "Trivar closed before the scene was saved. Save it to keep it.");
}

const std::optional<LeftScene>& Recovery::left_scene() const
{
    if (std::exchange(left_looked_for_, session_->scenes()) == session_->scenes())
        return left_scene_;
    left_scene_.reset();
    const std::optional<std::string> left = SceneFile::left_in(session_->unnamed_folder());
    struct stat status {};
    if (left && ::stat(left->c_str(), &status) == 0)
        left_scene_ = LeftScene{*left, status.st_mtime};
    return left_scene_;
}

void Recovery::tell_of_left_scene()
{
    const std::optional<std::string> left = SceneFile::left_in(session_->unnamed_folder());
    if (!left) return;
    session_->notices.say(
        ui::NoticeKind::warning, "Trivar closed before a scene was saved",
        "Every finished step is safe in the recovery folder.", of_left_scene,
        {{"Recover", [this] { take_up_left_scene(); }}, {"Discard", [this, path = *left] {
                                                             SceneFile::set_aside(path);
                                                             left_looked_for_ = -1;
                                                             tell_of_discarded();
                                                         }}});
    session_->notices.keep(of_left_scene);
}

} // namespace trivar

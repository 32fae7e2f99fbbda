// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <ctime>
#include <optional>
#include <string>

namespace trivar {

// A LeftScene is the scene without a name that a killed program left.
struct LeftScene {
    std::string path;
    std::time_t when = 0; // it was written last
};

// Recovery handles scenes without a name, which are kept in the session's folder for them: the one
// that a killed program left, and those that were discarded. It tells of each scene that the
// session discards and offers to bring it back.
class Recovery {
public:
    explicit Recovery(Session& session);
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;
    ~Recovery();

    // Discarded scenes are kept for this many days; older ones are deleted at the next discarding,
    // or at once.
    int discarded_days = 30;
    void forget_discarded() const;

    const std::optional<LeftScene>& left_scene() const; // looked for once a scene
    void take_up_left_scene();                          // goes on with it
    void tell_of_left_scene();
    bool take_up(const std::string& path); // a scene that was set aside; tells why it cannot

private:
    void tell_of_discarded();

    Session* session_;
    mutable std::optional<LeftScene> left_scene_;
    mutable long left_looked_for_ = -1; // in which of the scenes
};

} // namespace trivar

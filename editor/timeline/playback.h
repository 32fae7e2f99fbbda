// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"
#include "ui/frame.h"

namespace trivar {

// Playback plays the frames of the scene by the clock: frames that come too late are left out, so
// that a second of the scene stays a second. While it is paused it costs nothing.
class Playback {
public:
    bool playing() const { return playing_; }
    void play(Session& session); // from the first frame where it stands at the last
    void pause() { playing_ = false; }
    // Called once per frame of the window; `loop`: the first frame follows the last one.
    void advance(Session& session, ui::Frame& frame, bool loop);

private:
    struct Since { // when it showed which frame
        double time_s = 0;
        int frame = 0;
        Time time;
    };
    bool playing_ = false;
    int shown_ = 0;
    std::optional<Since> since_;
};

} // namespace trivar

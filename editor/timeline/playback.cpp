// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/timeline/playback.h"

#include <algorithm>
#include <cmath>

namespace trivar {

void Playback::play(Session& session)
{
    const Time& time = session.document().time;
    if (session.frame() >= time.last_frame) session.show_frame(time.first_frame);
    playing_ = true;
    since_.reset();
}

void Playback::advance(Session& session, ui::Frame& frame, bool loop)
{
    constexpr double shortest_wait_s = 1e-3;
    if (!playing_) return;
    const Time& time = session.document().time;
    // Another hand on the frame or the rate: it goes on from there.
    if (!since_ || since_->time != time || session.frame() != shown_)
        since_ = Since{frame.time_s, session.frame(), time};
    const double passed = (frame.time_s - since_->time_s) * time.frames_per_second;
    const double count = 1.0 + time.last_frame - time.first_frame;
    double place = since_->frame - time.first_frame + std::floor(passed);
    if (place >= count) {
        playing_ = loop;
        place = loop ? std::fmod(place, count) : count - 1;
    }
    session.show_frame(time.first_frame + static_cast<int>(place));
    shown_ = session.frame();
    // A finished evaluation brings a frame of its own; drawing the window before would delay it.
    if (playing_ && session.up_to_date())
        frame.again_in(
            std::max(shortest_wait_s, (std::floor(passed) + 1 - passed) / time.frames_per_second));
}

} // namespace trivar

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/input.h"
#include "ui/theme.h"

#include <algorithm>
#include <functional>

namespace trivar::ui {

// A Frame is the input of the program that draws a frame, with its requests in return.
struct Frame {
    const Theme& theme;
    const std::vector<Event>& events; // what hands did since the last frame
    glm::vec2 size_px{0};
    double time_s = 0;        // on a steady clock
    bool close_asked = false; // somebody wants to close the window

    double again_in_s = 1e300;  // asked for: another frame after this time at the latest
    bool close = false;         // asked for: the end
    double interface_scale = 1; // asked for from the next frame on, times the monitor's, 0.75..2
    Look look = {};             // asked for from the next frame on
    bool full_screen = false;   // asked for from the next frame on
    void again_in(double seconds) { again_in_s = std::min(again_in_s, seconds); }
};
using DrawFrame = std::function<void(Frame&)>;

// A Pace decides when the next frame is due, so that an idle window draws nothing at all.
class Pace {
public:
    // After input a few frames are due: ImGui needs them for hovering and popups to settle.
    void input_came() { owed_ = 3; }
    // Another thread has a result to show: one frame is due now. The frames that settle it wait
    // until no more results come, because playing brings one result after the other.
    void result_came(double time_s)
    {
        constexpr double patience_s = 0.15;
        owed_ = std::max(owed_, 1);
        settles_s_ = time_s + patience_s;
    }
    void drawn(const Frame& frame)
    {
        owed_ = std::max(0, owed_ - 1);
        if (frame.time_s >= settles_s_) {
            owed_ = std::max(owed_, 1);
            settles_s_ = 1e300;
        }
        due_s_ = frame.again_in_s < 1e9 ? frame.time_s + frame.again_in_s : 1e300;
    }
    // The seconds until a frame is due: 0 means now, above 1e9 not before something happens.
    double wait_s(double time_s) const
    {
        return owed_ > 0 ? 0 : std::max(0.0, std::min(due_s_, settles_s_) - time_s);
    }

private:
    int owed_ = 3;
    double due_s_ = 1e300, settles_s_ = 1e300;
};

} // namespace trivar::ui

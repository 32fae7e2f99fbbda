// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"
#include "ui/timing_history.h"

#include <optional>

namespace trivar::ui {

// A TimedWay is one of several ways to do the same work.
struct TimedWay {
    std::string name, sentence;
    bool used = false;
    std::optional<double> time_ms = {}; // empty: not measured
    std::size_t vertices = 0;
    std::string off = {}; // difference from the exact result; empty: not compared
};

struct TimingSources {
    const TimingHistory& history;
    const Timings& evaluation; // the last one that computed something
    const Timings& at_rest;    // the passes of the last full picture, for which nobody waits
    std::size_t program_bytes = 0, uploaded_bytes = 0;
    std::vector<TimedWay> ways = {}; // of deforming
    std::string drawn = {}; // lines that say how much of the scene is drawn; empty: all of it
};

// A TimingView is the state of the overlay between frames.
struct TimingView {
    bool open = false;
    long held = 0; // number, from 1, of the picture that is shown in place of the newest; 0: none
    // Requests of this frame: another way, by its number; and that all ways are measured.
    std::optional<std::size_t> other_way = {};
    bool measure_ways = false;
};

// Draws a pill with the median; pressed, it opens a card with a bar for each of the last pictures,
// and with the stages of one picture with their times and shares: the newest, the one under the
// mouse, or the one that was clicked. `key` opens and closes it as well. The card leaves out what
// has no room; returns where it is, if there is room for any of it.
std::optional<Rect> draw_timing(const Theme& theme, const Rect& room, const TimingSources& sources,
                                TimingView& view, const std::string& key);

// The whole card as text, with the names that `--timings` writes.
std::string timing_text(const TimingSources& sources);

} // namespace trivar::ui
